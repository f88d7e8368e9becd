// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/collapsible_mesh.h"

#include "core/mesh/face_adjacency.h"

#include <algorithm>

namespace tetra {

CollapsibleMesh::CollapsibleMesh(std::uint32_t vertexCount, std::span<const std::array<std::uint32_t, 4>> tetrahedra)
    : tetrahedra_(tetrahedra.size()), slotOfVertex_(vertexCount, none), stamps_(tetrahedra.size(), 0)
{
    const FaceAdjacency adjacency = matchFaces(tetrahedra);
    for (std::uint32_t slot = 0; slot < slotCount(); ++slot) {
        Tetrahedron& tetrahedron = tetrahedra_[slot];
        tetrahedron.vertices = tetrahedra[slot];
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t neighbour = adjacency.neighbours[slot][i];
            if (neighbour == FaceAdjacency::none) {
                tetrahedron.neighbours[i] = firstTriangle + triangleCount();
                slotOfTriangle_.push_back(slot);
            } else {
                tetrahedron.neighbours[i] = FaceAdjacency::cellOf(neighbour);
            }
            slotOfVertex_[tetrahedron.vertices[i]] = slot;
        }
    }
}

std::array<std::uint32_t, 3> CollapsibleMesh::cornersOf(std::uint32_t triangle) const noexcept
{
    const Tetrahedron& tetrahedron = tetrahedra_[slotOfTriangle(triangle)];
    const auto& corners = cornersOfFace[indexOf(tetrahedron.neighbours, triangle)];
    return {tetrahedron.vertices[corners[0]], tetrahedron.vertices[corners[1]], tetrahedron.vertices[corners[2]]};
}

void CollapsibleMesh::findStar(std::uint32_t vertex, std::vector<std::uint32_t>& star) const
{
    star.clear();
    if (slotOfVertex_[vertex] == none)
        return;
    if (++stamp_ == 0) {
        std::ranges::fill(stamps_, 0);
        stamp_ = 1;
    }
    star.push_back(slotOfVertex_[vertex]);
    stamps_[star.front()] = stamp_;
    std::size_t count = 1;
    for (std::size_t next = 0; next < count; ++next) {
        const Tetrahedron& tetrahedron = tetrahedra_[star[next]];
        star.resize(count + 3);
        for (const std::uint8_t face : cornersOfFace[indexOf(tetrahedron.vertices, vertex)]) {
            const std::uint32_t neighbour = tetrahedron.neighbours[face];
            if (isTriangle(neighbour))
                continue;
            // Without a branch: whether it is there already is as good as random.
            star[count] = neighbour;
            count += stamps_[neighbour] != stamp_ ? 1 : 0;
            stamps_[neighbour] = stamp_;
        }
    }
    star.resize(count);
}

void CollapsibleMesh::collapse(std::uint32_t vertex, std::uint32_t target, std::span<const std::uint32_t> star)
{
    for (const std::uint32_t slot : star)
        if (tetrahedra_[slot].vertices[indexOf(tetrahedra_[slot].vertices, target)] == target)
            joinAcross(slot, vertex, target);
    for (const std::uint32_t slot : star) {
        Tetrahedron& tetrahedron = tetrahedra_[slot];
        if (!alive(slot))
            continue;
        tetrahedron.vertices[indexOf(tetrahedron.vertices, vertex)] = target;
        slotOfVertex_[target] = slot;
    }
    slotOfVertex_[vertex] = none;
}

/// Takes a tetrahedron out and puts its two neighbours, which differ by `vertex` and `target`, against one another.
void CollapsibleMesh::joinAcross(std::uint32_t slot, std::uint32_t vertex, std::uint32_t target)
{
    const Tetrahedron gone = tetrahedra_[slot];
    const std::uint32_t ofTarget = gone.neighbours[indexOf(gone.vertices, vertex)];
    const std::uint32_t ofVertex = gone.neighbours[indexOf(gone.vertices, target)];
    replaceNeighbour(ofTarget, slot, ofVertex);
    replaceNeighbour(ofVertex, slot, ofTarget);
    for (const std::uint32_t corner : gone.vertices)
        if (slotOfVertex_[corner] == slot && corner != vertex)
            slotOfVertex_[corner] = isTriangle(ofTarget) ? ofVertex : ofTarget;
    tetrahedra_[slot].vertices.fill(none);
}

void CollapsibleMesh::replaceNeighbour(std::uint32_t slot, std::uint32_t before, std::uint32_t after)
{
    if (isTriangle(slot)) {
        slotOfTriangle_[slot - firstTriangle] = after;
        return;
    }
    auto& neighbours = tetrahedra_[slot].neighbours;
    neighbours[indexOf(neighbours, before)] = after;
}

} // namespace tetra
