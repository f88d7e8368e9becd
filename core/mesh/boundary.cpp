// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/boundary.h"

#include "core/base/disjoint_sets.h"
#include "core/base/flat_index.h"
#include "core/base/sort_unique.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

#include <algorithm>

namespace tetra {

BoundaryFaces boundaryFaces(std::size_t vertexCount, std::span<const std::array<std::uint32_t, 4>> tetrahedra)
{
    const FaceAdjacency adjacency = matchFaces(tetrahedra);
    BoundaryFaces boundary;
    for (std::uint32_t cell = 0; cell < tetrahedra.size(); ++cell)
        for (std::uint32_t face = 0; face < 4; ++face)
            if ((adjacency.innerFaces[cell] >> face & 1) == 0)
                boundary.triangles.push_back(sideCorners(tetrahedra, 4 * cell + face));
    boundary.vertices = renumberUsed(boundary.triangles, vertexCount);
    return boundary;
}

namespace {

bool isBack(const std::array<std::uint32_t, 3>& face, const std::array<std::uint32_t, 3>& other)
{
    for (std::size_t turn = 0; turn < 3; ++turn)
        if (other[turn] == face[0])
            return other[(turn + 1) % 3] == face[2] && other[(turn + 2) % 3] == face[1];
    return false;
}

std::uint64_t keyOf(const std::array<std::uint32_t, 3>& face)
{
    return FaceMatching::keyOf(face[0]) + FaceMatching::keyOf(face[1]) + FaceMatching::keyOf(face[2]);
}

} // namespace

std::array<std::uint32_t, 3> sideCorners(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::uint32_t side)
{
    const auto& tetrahedron = tetrahedra[FaceAdjacency::cellOf(side)];
    const auto& corners = cornersOfFace[FaceAdjacency::faceOf(side)];
    return {tetrahedron[corners[0]], tetrahedron[corners[1]], tetrahedron[corners[2]]};
}

MeshFaces findMeshFaces(std::span<const std::array<std::uint32_t, 4>> tetrahedra)
{
    MeshFaces faces;
    const auto sides = static_cast<std::uint32_t>(4 * tetrahedra.size());
    faces.partners.assign(sides, MeshFaces::none);
    FaceMatching matching(2 * std::uint64_t(sides)); // even if no two tetrahedra share a face
    std::vector<std::uint64_t> crowdedKeys;
    constexpr std::uint32_t ahead = 16;
    for (std::uint32_t side = 0; side < sides; ++side) {
        if (side + ahead < sides)
            matching.prefetch(keyOf(sideCorners(tetrahedra, side + ahead)));
        const std::uint64_t key = keyOf(sideCorners(tetrahedra, side));
        const std::uint32_t other = matching.add(key, side);
        if (other == side)
            crowdedKeys.push_back(key);
        else if (other != FaceMatching::none) {
            faces.partners[side] = other;
            faces.partners[other] = side;
        }
    }
    std::ranges::sort(crowdedKeys);
    for (std::uint32_t side = 0; side < sides; ++side) {
        const std::uint32_t other = faces.partners[side];
        const auto corners = sideCorners(tetrahedra, side);
        if (!crowdedKeys.empty() && std::ranges::binary_search(crowdedKeys, keyOf(corners)))
            faces.crowded.push_back(FaceAdjacency::cellOf(side));
        else if (other == MeshFaces::none)
            faces.boundary.push_back(side);
        else if (!isBack(corners, sideCorners(tetrahedra, other)))
            faces.folded.push_back(FaceAdjacency::cellOf(side));
    }
    sortUnique(faces.crowded);
    sortUnique(faces.folded);
    return faces;
}

namespace {

/// One triangle's share of an edge: its corner place `corner` is where it starts along the edge.
struct EdgeUse {
    EdgeKey edge;
    std::uint32_t triangle;
    std::uint8_t corner;
    bool upwards; ///< from the smaller vertex to the larger
};

std::vector<EdgeUse> sortedEdgeUses(std::span<const Triangle> triangles)
{
    std::vector<EdgeUse> uses;
    uses.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::uint8_t i = 0; i < 3; ++i) {
            const std::uint32_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
            uses.push_back({edgeKey(from, to), t, i, from < to});
        }
    std::ranges::sort(uses, [](const EdgeUse& a, const EdgeUse& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle;
    });
    return uses;
}

/// Calls visit(first, count) for the uses of each edge.
template <class Visit> void forEdges(const std::vector<EdgeUse>& uses, Visit&& visit)
{
    for (std::size_t first = 0; first < uses.size();) {
        std::size_t end = first + 1;
        while (end < uses.size() && uses[end].edge == uses[first].edge)
            ++end;
        visit(first, end - first);
        first = end;
    }
}

bool sound(const EdgeUse& a, const EdgeUse& b)
{
    return a.upwards != b.upwards;
}

} // namespace

ManifoldBreaches findBreaches(std::span<const Triangle> triangles)
{
    ManifoldBreaches breaches;
    const std::vector<EdgeUse> uses = sortedEdgeUses(triangles);
    DisjointSets fans(3 * triangles.size()); // of the corners of triangles
    forEdges(uses, [&](std::size_t first, std::size_t count) {
        const EdgeUse& a = uses[first];
        if (count != 2 || !sound(a, uses[first + 1])) {
            breaches.edges.push_back(endsOf(a.edge));
            return;
        }
        // Where one starts along the edge, the other ends.
        const EdgeUse& b = uses[first + 1];
        fans.join(3 * a.triangle + a.corner, 3 * b.triangle + (b.corner + 1) % 3);
        fans.join(3 * a.triangle + (a.corner + 1) % 3, 3 * b.triangle + b.corner);
    });
    FlatIndex<std::uint32_t> breached; // ends of breached edges
    for (const auto& [a, b] : breaches.edges) {
        breached.numberOf(a);
        breached.numberOf(b);
    }
    std::vector<std::uint32_t> centres;
    for (std::uint32_t corner = 0; corner < 3 * triangles.size(); ++corner)
        if (fans.root(corner) == corner)
            if (const std::uint32_t vertex = triangles[corner / 3][corner % 3]; !breached.contains(vertex))
                centres.push_back(vertex);
    std::ranges::sort(centres);
    for (std::size_t i = 1; i < centres.size(); ++i)
        if (centres[i] == centres[i - 1] && (breaches.vertices.empty() || breaches.vertices.back() != centres[i]))
            breaches.vertices.push_back(centres[i]);
    return breaches;
}

std::vector<std::uint32_t> surfacePieces(std::span<const Triangle> triangles, const std::vector<bool>& alone)
{
    const std::vector<EdgeUse> uses = sortedEdgeUses(triangles);
    const auto isAlone = [&](const EdgeUse& use) { return !alone.empty() && alone[use.triangle]; };
    DisjointSets joined(triangles.size());
    forEdges(uses, [&](std::size_t first, std::size_t count) {
        if (count == 2 && !isAlone(uses[first]) && !isAlone(uses[first + 1]))
            joined.join(uses[first].triangle, uses[first + 1].triangle);
    });
    std::vector<std::uint32_t> pieces(triangles.size());
    std::uint32_t count = 0;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const std::uint32_t root = joined.root(t);
        pieces[t] = root == t ? count++ : pieces[root];
    }
    return pieces;
}

} // namespace tetra
