// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/isosurface.h"

#include "core/graphics/crossed_tetrahedra.h"
#include "core/graphics/edge_vertices.h"
#include "core/graphics/marching_cases.h"
#include "core/graphics/surface_normals.h"
#include "core/graphics/vertex_welding.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <new>
#include <string>

namespace tetra {
namespace {

constexpr std::string_view activity = "Extracting the isosurface";

using Triangle = std::array<std::uint32_t, 3>;

/// Calls visit for each triangle of a chunk that has three different corners.
template <class Visit> void forEachTriangle(const CrossedChunk& chunk, const std::uint32_t* corners, Visit&& visit)
{
    const auto visitUnlessFlat = [&](const Triangle& t) {
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
            visit(t);
    };
    for (const std::uint32_t entry : chunk.entries) {
        const int count = marchingCases[CrossedChunk::caseOf(entry)].corners;
        visitUnlessFlat({corners[0], corners[1], corners[2]});
        if (count == 4)
            visitUnlessFlat({corners[0], corners[2], corners[3]});
        corners += count;
    }
}

Buffer<Triangle> makeTriangles(std::span<const CrossedChunk> chunks, const EdgeVertices& vertices)
{
    const auto cornersOf = [&](std::size_t c) { return vertices.cornerVertex.data() + vertices.firstCorner[c]; };
    const tbb::blocked_range<std::size_t> allChunks(0, chunks.size());
    std::vector<std::uint64_t> first(chunks.size() + 1, 0);
    tbb::parallel_for(allChunks, [&](const auto& range) {
        for (std::size_t c = range.begin(); c != range.end(); ++c)
            forEachTriangle(chunks[c], cornersOf(c), [&](const Triangle&) { ++first[c + 1]; });
    });
    for (std::size_t c = 0; c < chunks.size(); ++c)
        first[c + 1] += first[c];

    Buffer<Triangle> triangles(first.back());
    tbb::parallel_for(allChunks, [&](const auto& range) {
        for (std::size_t c = range.begin(); c != range.end(); ++c) {
            std::uint64_t next = first[c];
            forEachTriangle(chunks[c], cornersOf(c), [&](const Triangle& triangle) { triangles[next++] = triangle; });
        }
    });
    return triangles;
}

Status checkArguments(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients, double isovalue)
{
    if (std::isnan(isovalue))
        return Error{ErrorKind::WrongUsage, "The isovalue is not a number."};
    if (mesh.values.size() != mesh.positions.size() || gradients.size() != mesh.positions.size())
        return Error{ErrorKind::WrongUsage, "The mesh, its values and its gradients do not belong together."};
    return {};
}

Result<TriangleMesh> extract(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients, double isovalue,
                             const Progress& progress)
{
    progress.report(0, activity);
    const std::vector<CrossedChunk> chunks = findCrossedTetrahedra(mesh, isovalue, progress);
    if (progress.cancelled())
        return cancelledError(activity);
    std::uint64_t corners = 0;
    for (const CrossedChunk& chunk : chunks)
        corners += chunk.corners;
    if (corners > largestCornerCount)
        return Error{ErrorKind::OutOfResource, "The isosurface has more than four thousand million corners. Lower the "
                                               "accuracy of the mesh."};

    progress.report(0.4, activity);
    EdgeVertices vertices = numberEdgeVertices(mesh, chunks);
    if (progress.cancelled())
        return cancelledError(activity);
    progress.report(0.7, activity);
    CrossingPoints points = crossingPoints(mesh, vertices, isovalue);
    weldAtMeshVertices(vertices, points);
    if (progress.cancelled())
        return cancelledError(activity);

    progress.report(0.8, activity);
    TriangleMesh surface;
    surface.triangles = makeTriangles(chunks, vertices);
    surface.positions = std::move(points.positions);
    makeNormals(surface, vertices, points, gradients);
    progress.report(1, activity);
    return surface;
}

} // namespace

Result<TriangleMesh> extractIsosurface(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients,
                                       double isovalue, const Progress& progress)
{
    if (Status status = checkArguments(mesh, gradients, isovalue); !status)
        return status.error();
    try {
        return extract(mesh, gradients, isovalue, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory for the isosurface. Close other programs or lower the accuracy of the mesh."};
    }
}

} // namespace tetra
