// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/link_condition.h"

#include <algorithm>

namespace tetra {

namespace {

template <class Number> void sortOut(std::vector<Number>& numbers)
{
    std::ranges::sort(numbers);
    numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
}

template <class Number> bool has(const std::vector<Number>& sorted, Number number)
{
    return std::ranges::binary_search(sorted, number);
}

} // namespace

void LinkCondition::set(const VertexStar& star)
{
    link_.assign(star.link().begin(), star.link().end());
    edges_.clear();
    rim_.clear();
    rimEdges_.clear();
    const auto link = star.link();
    for (const auto& [a, b, c] : star.faces())
        edges_.insert(edges_.end(), {edgeOf(link[a], link[b]), edgeOf(link[b], link[c]), edgeOf(link[c], link[a])});
    for (const VertexStar::RimTriangle& triangle : star.rim()) {
        const std::uint32_t a = link[triangle.corners[0]], b = link[triangle.corners[1]];
        rim_.insert(rim_.end(), {a, b});
        rimEdges_.push_back(edgeOf(a, b));
    }
    std::ranges::sort(link_);
    sortOut(edges_);
    sortOut(rim_);
    sortOut(rimEdges_);
}

bool LinkCondition::isOnRim(std::uint32_t vertex) const
{
    return has(rim_, vertex);
}

/// Whether a tetrahedron vanishes that has its face opposite to the target on the boundary. Then the one behind its
/// face opposite to the vertex, which the collapse does not touch, gets onto the boundary, and the history, in which a
/// site depends on what it destroys alone, would not say that the vertex needs it: closed sets would have cracks.
bool LinkCondition::leavesFaceOpen(const VertexStar& star, std::uint32_t linkPlace)
{
    return std::ranges::any_of(star.rim(), [&](const VertexStar::RimTriangle& triangle) {
        return star.holds(triangle.slotPlace, linkPlace) && triangle.corners[0] != linkPlace &&
               triangle.corners[1] != linkPlace;
    });
}

bool LinkCondition::allows(const CollapsibleMesh& mesh, const VertexStar& star, std::uint32_t linkPlace)
{
    const std::uint32_t vertex = star.vertex(), target = star.link()[linkPlace];
    if (!isOnRim(target) || leavesFaceOpen(star, linkPlace))
        return false;
    shared_.clear();
    sharedEdges_.clear();
    sharedRim_.clear();
    for (std::size_t face = 0; face < star.faces().size(); ++face)
        if (star.holds(face, linkPlace)) {
            std::uint32_t others[2];
            std::size_t count = 0;
            for (const std::uint32_t corner : star.faces()[face])
                if (corner != linkPlace)
                    others[count++] = star.link()[corner];
            shared_.insert(shared_.end(), {others[0], others[1]});
            sharedEdges_.push_back(edgeOf(others[0], others[1]));
        }
    for (const VertexStar::RimTriangle& triangle : star.rim())
        for (std::size_t i = 0; i < 2; ++i)
            if (triangle.corners[i] == linkPlace)
                sharedRim_.push_back(star.link()[triangle.corners[1 - i]]);
    sortOut(shared_);
    sortOut(sharedEdges_);
    if (sharedRim_.size() != 2)
        return false;

    for (const std::uint32_t slot : mesh.star(target)) {
        const CollapsibleMesh::Four& vertices = mesh.vertices(slot);
        const CollapsibleMesh::Four& neighbours = mesh.neighbours(slot);
        const std::size_t own = indexOf(vertices, target);
        if (std::ranges::find(vertices, vertex) != vertices.end()) {
            // A face of the target and one of the vertex would fold onto one another.
            const std::size_t other = indexOf(vertices, vertex);
            if (CollapsibleMesh::isTriangle(neighbours[own]) && CollapsibleMesh::isTriangle(neighbours[other]))
                return false;
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t corner = vertices[i];
            if (i != own && corner != vertex && has(link_, corner) && !has(shared_, corner))
                return false;
        }
        for (std::size_t i = 0; i < 4; ++i) {
            if (i == own)
                continue;
            // The edge opposite to the target and corner i.
            std::uint32_t ends[2];
            std::size_t count = 0;
            for (std::size_t k = 0; k < 4; ++k)
                if (k != own && k != i)
                    ends[count++] = vertices[k];
            if (ends[0] == vertex || ends[1] == vertex)
                continue;
            const Edge edge = edgeOf(ends[0], ends[1]);
            if (has(edges_, edge) && !has(sharedEdges_, edge))
                return false;
            if (!CollapsibleMesh::isTriangle(neighbours[i]))
                continue;
            if (has(rimEdges_, edge))
                return false;
            for (const std::uint32_t end : ends)
                if (has(rim_, end) && end != sharedRim_[0] && end != sharedRim_[1])
                    return false;
        }
    }
    return true;
}

} // namespace tetra
