// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/collapsible_mesh.h"

#include <algorithm>

namespace tetra {

CollapsibleMesh::CollapsibleMesh(std::uint32_t vertexCount, std::span<const Four> tetrahedra, bool withNeighbours)
    : stars_(vertexCount)
{
    tetrahedra_.reserve(tetrahedra.size());
    for (const Four& vertices : tetrahedra)
        tetrahedra_.push_back({vertices, {}});
    if (withNeighbours)
        findNeighbours(tetrahedra);
    setStars(vertexCount);
}

void CollapsibleMesh::findNeighbours(std::span<const Four> tetrahedra)
{
    neighbours_.resize(tetrahedra.size());
    const FaceAdjacency adjacency = matchFaces(tetrahedra);
    for (std::uint32_t slot = 0; slot < slotCount(); ++slot)
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t neighbour = adjacency.neighbours[slot][i];
            if (neighbour == FaceAdjacency::none) {
                neighbours_[slot][i] = firstTriangle + triangleCount();
                slotOfTriangle_.push_back(slot);
            } else {
                neighbours_[slot][i] = FaceAdjacency::cellOf(neighbour);
            }
        }
}

void CollapsibleMesh::setStars(std::uint32_t vertexCount)
{
    for (const Tetrahedron& tetrahedron : tetrahedra_)
        for (const std::uint32_t vertex : tetrahedron.vertices)
            ++stars_[vertex].count;
    for (std::uint32_t vertex = 0; vertex < vertexCount; ++vertex)
        stars_[vertex] = {pool_.allocate(stars_[vertex].count).place, 0};
    for (std::uint32_t slot = 0; slot < slotCount(); ++slot)
        for (const std::uint32_t vertex : vertices(slot)) {
            ++stars_[vertex].count;
            pool_[stars_[vertex]].back() = slot;
        }
}

std::array<std::uint32_t, 3> CollapsibleMesh::cornersOf(std::uint32_t triangle) const noexcept
{
    const std::uint32_t slot = slotOfTriangle(triangle);
    return cornersOfFaceOf(slot, indexOf(neighbours_[slot], triangle));
}

void CollapsibleMesh::collapse(std::uint32_t vertex, std::uint32_t target)
{
    moved_.clear();
    for (const std::uint32_t slot : star(vertex)) {
        Four& vertices = tetrahedra_[slot].vertices;
        if (vertices[indexOf(vertices, target)] == target) {
            remove(slot, vertex, target);
            continue;
        }
        vertices[indexOf(vertices, vertex)] = target;
        moved_.push_back(slot);
    }
    pool_.release(stars_[vertex]);
    stars_[vertex] = {};
    stars_[target] = pool_.appended(stars_[target], moved_);
}

/// Takes a tetrahedron out and puts its two neighbours, which differ by `vertex` and `target`, against one another.
void CollapsibleMesh::remove(std::uint32_t slot, std::uint32_t vertex, std::uint32_t target)
{
    Four& vertices = tetrahedra_[slot].vertices;
    if (!neighbours_.empty()) {
        const std::uint32_t ofTarget = neighbours_[slot][indexOf(vertices, vertex)];
        const std::uint32_t ofVertex = neighbours_[slot][indexOf(vertices, target)];
        replaceNeighbour(ofTarget, slot, ofVertex);
        replaceNeighbour(ofVertex, slot, ofTarget);
    }
    for (const std::uint32_t corner : vertices)
        if (corner != vertex)
            stars_[corner] = pool_.without(stars_[corner], slot);
    vertices.fill(none);
}

void CollapsibleMesh::replaceNeighbour(std::uint32_t slot, std::uint32_t before, std::uint32_t after)
{
    if (isTriangle(slot)) {
        slotOfTriangle_[slot - firstTriangle] = after;
        return;
    }
    Four& neighbours = neighbours_[slot];
    neighbours[indexOf(neighbours, before)] = after;
}

} // namespace tetra
