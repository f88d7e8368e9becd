// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/vertex_star.h"

#include <cmath>

namespace tetra {

VertexStar::VertexStar(std::span<const Eigen::Vector3d> positions, bool exact)
    : positions_(positions), doubt_(exact ? 0 : 1e-13), placeInLink_(positions.size(), 0)
{
}

void VertexStar::set(const CollapsibleMesh& mesh, std::uint32_t vertex)
{
    vertex_ = vertex;
    mesh.findStar(vertex, slots_);
    link_.clear();
    faces_.clear();
    places_.clear();
    planes_.clear();
    rim_.clear();
    for (const std::uint32_t slot : slots_) {
        // An even permutation brings the vertex to the front.
        constexpr std::uint8_t order[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
        const auto& vertices = mesh[slot].vertices;
        const std::size_t own = indexOf(vertices, vertex);
        const auto& others = order[own];
        faces_.push_back(
            {linkPlaceOf(vertices[others[0]]), linkPlaceOf(vertices[others[1]]), linkPlaceOf(vertices[others[2]])});
        planes_.push_back(planeOf(faces_.back()));
        addRim(mesh[slot], own);
    }
}

/// The boundary triangles among the faces of the tetrahedron met last that have the vertex.
void VertexStar::addRim(const CollapsibleMesh::Tetrahedron& tetrahedron, std::size_t own)
{
    for (std::size_t face = 0; face < 4; ++face) {
        if (face == own || !CollapsibleMesh::isTriangle(tetrahedron.neighbours[face]))
            continue;
        const auto& [a, b, c] = faces_.back();
        // Of (vertex, a, b, c) the faces (vertex, c, b), (vertex, a, c) and (vertex, b, a) look outwards.
        const std::uint32_t opposite = linkPlaceOf(tetrahedron.vertices[face]);
        rim_.push_back({tetrahedron.neighbours[face], static_cast<std::uint32_t>(faces_.size() - 1),
                        opposite == a   ? std::array{c, b}
                        : opposite == b ? std::array{a, c}
                                        : std::array{b, a}});
    }
}

bool VertexStar::rimIsOneCycle() const
{
    if (rim_.empty())
        return false;
    std::vector<std::uint32_t> next(link_.size(), CollapsibleMesh::none);
    for (const RimTriangle& triangle : rim_) {
        if (next[triangle.corners[0]] != CollapsibleMesh::none)
            return false;
        next[triangle.corners[0]] = triangle.corners[1];
    }
    std::size_t length = 1;
    const std::uint32_t first = rim_.front().corners[0];
    std::uint32_t at = next[first];
    for (; at != first && at != CollapsibleMesh::none && length <= rim_.size(); ++length)
        at = next[at];
    return at == first && length == rim_.size();
}

std::uint32_t VertexStar::linkPlaceOf(std::uint32_t vertex)
{
    const std::uint32_t known = placeInLink_[vertex];
    if (known < link_.size() && link_[known] == vertex)
        return known;
    const auto place = static_cast<std::uint32_t>(link_.size());
    placeInLink_[vertex] = place;
    link_.push_back(vertex);
    const Eigen::Vector3d from = positions_[vertex] - positions_[vertex_];
    places_.push_back({from.x(), from.y(), from.z()});
    return place;
}

VertexStar::Plane VertexStar::planeOf(const std::array<std::uint32_t, 3>& face) const
{
    const auto& [a, b, c] = face;
    Plane plane;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const auto along = [&](std::uint32_t to, std::size_t axis) { return places_[to][axis] - places_[a][axis]; };
        const double plus = along(b, j) * along(c, k), minus = along(b, k) * along(c, j);
        plane.normal[i] = plus - minus;
        plane.magnitude[i] = std::abs(plus) + std::abs(minus);
        plane.offset += plane.normal[i] * places_[a][i];
        plane.offsetMagnitude += plane.magnitude[i] * std::abs(places_[a][i]);
    }
    return plane;
}

bool VertexStar::opensOnto(std::uint32_t linkPlace) const
{
    const std::array<double, 3>& to = places_[linkPlace];
    bool any = false;
    for (std::size_t face = 0; face < faces_.size(); ++face) {
        if (holds(face, linkPlace))
            continue;
        const Plane& plane = planes_[face];
        double volume = plane.offset;
        double magnitude = plane.offsetMagnitude;
        for (std::size_t i = 0; i < 3; ++i) {
            volume -= plane.normal[i] * to[i];
            magnitude += plane.magnitude[i] * std::abs(to[i]);
        }
        if (!(volume > doubt_ * magnitude))
            return false;
        any = true;
    }
    return any;
}

} // namespace tetra
