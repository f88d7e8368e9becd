// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/boundary_convexity.h"

#include "core/base/disjoint_sets.h"
#include "core/mesh/topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace tetra {
namespace {

constexpr double deepestDent = 1e-5;

/// An edge of a face of the boundary, and the face's third corner.
struct BoundaryEdge {
    std::uint32_t low, high;
    std::uint32_t third;
    std::uint32_t face; ///< its number among the boundary's
    bool forwards;      ///< seen from outside the face has its corners as low, high, third counterclockwise
    auto operator<=>(const BoundaryEdge&) const = default;
};

std::vector<BoundaryEdge> boundaryEdges(const TetrahedralMesh& mesh, const FaceAdjacency& adjacency)
{
    std::vector<BoundaryEdge> edges;
    for (std::size_t cell = 0; cell < mesh.tetrahedra.size(); ++cell)
        for (std::size_t face = 0; face < 4; ++face) {
            if (adjacency.neighbours[cell][face] != FaceAdjacency::none)
                continue;
            const auto number = static_cast<std::uint32_t>(edges.size() / 3);
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = mesh.tetrahedra[cell][cornersOfFace[face][i]];
                const std::uint32_t b = mesh.tetrahedra[cell][cornersOfFace[face][(i + 1) % 3]];
                const std::uint32_t c = mesh.tetrahedra[cell][cornersOfFace[face][(i + 2) % 3]];
                edges.push_back({std::min(a, b), std::max(a, b), c, number, a < b});
            }
        }
    std::ranges::sort(edges);
    return edges;
}

/// How far the third corner of the one face lies before the plane of the other; not a number if that has no plane.
double heightOver(const TetrahedralMesh& mesh, const BoundaryEdge& one, const BoundaryEdge& other)
{
    const auto at = [&](std::uint32_t vertex) -> Eigen::Vector3d { return mesh.positions[vertex].cast<double>(); };
    const Eigen::Vector3d start = at(other.low);
    const Eigen::Vector3d normal = (at(other.high) - start).cross(at(other.third) - start).normalized();
    return (other.forwards ? 1 : -1) * normal.dot(at(one.third) - start);
}

} // namespace

bool hasConvexBoundary(const TetrahedralMesh& mesh, const FaceAdjacency& adjacency)
{
    const std::vector<BoundaryEdge> edges = boundaryEdges(mesh, adjacency);
    if (edges.empty() || edges.size() % 2 != 0)
        return false;
    Eigen::AlignedBox3f bounds;
    for (const BoundaryEdge& edge : edges)
        bounds.extend(mesh.positions[edge.third]);
    const double dent = deepestDent * bounds.diagonal().norm();

    DisjointSets surfaces(edges.size() / 3);
    for (std::size_t i = 0; i < edges.size(); i += 2) {
        const BoundaryEdge &one = edges[i], &other = edges[i + 1];
        const bool pair = one.low == other.low && one.high == other.high && one.forwards != other.forwards;
        const bool alone = i + 2 == edges.size() || edges[i + 2].low != one.low || edges[i + 2].high != one.high;
        if (!pair || !alone || !(heightOver(mesh, one, other) <= dent))
            return false;
        surfaces.join(one.face, other.face);
    }
    for (std::uint32_t face = 1; face < surfaces.size(); ++face)
        if (surfaces.root(face) != 0)
            return false;
    return true;
}

} // namespace tetra
