// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/boundary_extraction.h"

#include "core/base/disjoint_sets.h"
#include "core/mesh/boundary_faces.h"
#include "core/mesh/face_adjacency.h"

#include <Eigen/Geometry>

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <new>
#include <numbers>
#include <span>

namespace tetra {
namespace {

constexpr std::string_view findingBoundary = "Finding the boundary";
constexpr std::size_t largestTriangleCount = 0xffffffff / 3; // corners have numbers

Error tooManyFaces()
{
    return {ErrorKind::OutOfResource,
            "The mesh has too many tetrahedra for its boundary to be shown. Lower the accuracy of the mesh."};
}

using Triangle = std::array<std::uint32_t, 3>;

/// An edge as one of its triangles has it. Corner c of triangle t has the number 3 t + c.
struct EdgeSide {
    std::uint64_t ends;   ///< the smaller vertex, times 2^32, plus the larger one
    std::uint32_t corner; ///< that the edge begins at, seen from the triangle
    auto operator<=>(const EdgeSide&) const = default;
};

constexpr std::uint32_t nextCorner(std::uint32_t corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// The boundary while its vertices are being made.
struct Boundary {
    std::span<const Triangle> triangles; ///< of vertices of the mesh's boundary
    Buffer<Eigen::Vector3d> corners;     ///< the place of each corner
    Buffer<Eigen::Vector3d> normals;     ///< of each triangle, of length one; zero if it has no area

    std::uint32_t vertexOf(std::uint32_t corner) const { return triangles[corner / 3][corner % 3]; }
    double angleAt(std::uint32_t corner) const;
};

double Boundary::angleAt(std::uint32_t corner) const
{
    const std::uint32_t next = nextCorner(corner);
    const Eigen::Vector3d one = corners[next] - corners[corner];
    const Eigen::Vector3d other = corners[nextCorner(next)] - corners[corner];
    return std::atan2(one.cross(other).norm(), one.dot(other));
}

Boundary boundaryOf(std::span<const Triangle> triangles, const auto& placeOf)
{
    Boundary boundary{triangles, Buffer<Eigen::Vector3d>(3 * triangles.size()),
                      Buffer<Eigen::Vector3d>(triangles.size())};
    tbb::parallel_for(std::size_t(0), triangles.size(), [&](std::size_t t) {
        Eigen::Vector3d* corners = &boundary.corners[3 * t];
        for (std::size_t c = 0; c < 3; ++c)
            corners[c] = placeOf(triangles[t][c]);
        // stableNormalized() leaves zero as it is.
        boundary.normals[t] = (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
    });
    return boundary;
}

Buffer<EdgeSide> sortedSides(const Boundary& boundary)
{
    Buffer<EdgeSide> sides(boundary.corners.size());
    tbb::parallel_for(std::uint32_t(0), static_cast<std::uint32_t>(sides.size()), [&](std::uint32_t corner) {
        const std::uint64_t from = boundary.vertexOf(corner), to = boundary.vertexOf(nextCorner(corner));
        sides[corner] = {std::min(from, to) << 32 | std::max(from, to), corner};
    });
    tbb::parallel_sort(sides.begin(), sides.end());
    return sides;
}

/// Joins the corners that two triangles have at their common edge, where the boundary is smooth there.
DisjointSets smoothCorners(const Boundary& boundary, double featureAngle)
{
    const double smallestCosine = std::cos(featureAngle * std::numbers::pi / 180);
    const auto isSmooth = [&](std::uint32_t one, std::uint32_t other) {
        return featureAngle > 0 && boundary.normals[one / 3].dot(boundary.normals[other / 3]) >= smallestCosine;
    };
    DisjointSets joined(boundary.corners.size());
    const Buffer<EdgeSide> sides = sortedSides(boundary);
    for (auto begin = sides.begin(); begin != sides.end();) {
        const auto end =
            std::find_if(begin, sides.end(), [&](const EdgeSide& side) { return side.ends != begin->ends; });
        const std::uint32_t one = begin->corner, other = (end - 1)->corner;
        // The edge begins in one triangle where it ends in the other.
        if (end - begin == 2 && boundary.vertexOf(one) == boundary.vertexOf(nextCorner(other)) &&
            isSmooth(one, other)) {
            joined.join(one, nextCorner(other));
            joined.join(nextCorner(one), other);
        }
        begin = end;
    }
    return joined;
}

/// Makes a vertex of each set of corners.
TriangleMesh surfaceOf(const Boundary& boundary, DisjointSets& joined, const auto& valueOf)
{
    TriangleMesh surface;
    surface.triangles.resize(boundary.triangles.size());
    Buffer<std::uint32_t> numbers(boundary.corners.size()); // of the corners that are roots, which come first
    std::vector<Eigen::Vector3d> normals;
    for (std::uint32_t corner = 0; corner < numbers.size(); ++corner) {
        const std::uint32_t root = joined.root(corner);
        if (root == corner) {
            numbers[corner] = static_cast<std::uint32_t>(normals.size());
            normals.emplace_back(0, 0, 0);
            surface.positions.push_back(boundary.corners[corner].cast<float>());
            surface.values.push_back(valueOf(boundary.vertexOf(corner)));
        }
        const std::uint32_t vertex = numbers[root];
        surface.triangles[corner / 3][corner % 3] = vertex;
        normals[vertex] += boundary.angleAt(corner) * boundary.normals[corner / 3];
    }
    surface.normals.reserve(normals.size());
    for (const Eigen::Vector3d& normal : normals)
        surface.normals.push_back(normal.isZero(0) ? Eigen::Vector3f::UnitZ().eval()
                                                   : normal.stableNormalized().cast<float>().eval());
    return surface;
}

Result<TriangleMesh> boundaryOfMesh(const TetrahedralMesh& mesh, double featureAngle, const Progress& progress)
{
    const BoundaryFaces faces = boundaryFaces(mesh.positions.size(), mesh.tetrahedra);
    if (faces.triangles.size() > largestTriangleCount)
        return tooManyFaces();
    if (progress.cancelled())
        return cancelledError(findingBoundary);
    progress.report(0.5, findingBoundary);
    const Boundary boundary = boundaryOf(faces.triangles, [&](std::uint32_t vertex) -> Eigen::Vector3d {
        return mesh.positions[faces.vertices[vertex]].cast<double>();
    });
    DisjointSets joined = smoothCorners(boundary, featureAngle);
    if (progress.cancelled())
        return cancelledError(findingBoundary);
    TriangleMesh surface =
        surfaceOf(boundary, joined, [&](std::uint32_t vertex) { return mesh.values[faces.vertices[vertex]]; });
    progress.report(1, findingBoundary);
    return surface;
}

} // namespace

Result<TriangleMesh> extractBoundary(const TetrahedralMesh& mesh, double featureAngle, const Progress& progress)
try {
    progress.report(0, findingBoundary);
    if (mesh.tetrahedra.size() > largestAdjacentCellCount)
        return tooManyFaces();
    return boundaryOfMesh(mesh, featureAngle, progress);
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource,
                 "Not enough memory for the boundary of the mesh. Lower the accuracy of the mesh."};
}

} // namespace tetra
