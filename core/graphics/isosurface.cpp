// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/isosurface.h"

#include "core/base/simd.h"
#include "core/graphics/surface_normals.h"
#include "core/graphics/surface_runs.h"
#include "core/graphics/surface_vertices.h"
#include "core/graphics/vertex_placing.h"
#include "core/graphics/vertex_welding.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <new>
#include <string>

namespace tetra {
namespace {

constexpr std::string_view extractingIsosurface = "Extracting the isosurface";

using Triangle = std::array<std::uint32_t, 3>;

TETRA_SIMD_CLONES void renumber(const Triangle* triangles, std::size_t count, const std::uint32_t* numbers,
                                Triangle* renumbered)
{
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t corner = 0; corner < 3; ++corner)
            renumbered[i][corner] = numbers[triangles[i][corner]];
}

Buffer<Triangle> joinTriangles(std::span<const SurfaceRun> runs, const SurfaceVertices& vertices)
{
    std::vector<std::size_t> first(1, 0);
    for (const SurfaceRun& run : runs)
        first.push_back(first.back() + run.triangles.size());
    Buffer<Triangle> triangles(first.back());
    tbb::parallel_for(std::size_t(0), runs.size(), [&](std::size_t run) {
        renumber(runs[run].triangles.data(), runs[run].triangles.size(),
                 vertices.numbers.data() + vertices.firstOfRun[run], triangles.data() + first[run]);
    });
    return triangles;
}

Status checkArguments(const TetrahedralMesh& mesh, const IsosurfaceIndex* index,
                      std::span<const Eigen::Vector3f> gradients, double isovalue)
{
    if (std::isnan(isovalue))
        return Error{ErrorKind::WrongUsage, "The isovalue is not a number."};
    const std::size_t vertices = mesh.positions.size();
    const std::size_t chunks = (mesh.tetrahedra.size() + rangedChunkSize - 1) / rangedChunkSize;
    if (mesh.values.size() != vertices || gradients.size() != vertices ||
        (index != nullptr && (index->inOneRun.size() != vertices || index->ranges.size() != chunks)))
        return Error{ErrorKind::WrongUsage,
                     "The mesh, its values, its gradients and its index do not belong together."};
    return {};
}

Result<TriangleMesh> extract(const TetrahedralMesh& mesh, const IsosurfaceIndex* index,
                             std::span<const Eigen::Vector3f> gradients, double isovalue, const Progress& progress)
{
    progress.report(0, extractingIsosurface);
    const std::vector<SurfaceRun> runs = makeSurfaceRuns(mesh, index, isovalue, progress);
    if (progress.cancelled())
        return cancelledError(extractingIsosurface);
    std::uint64_t edges = 0;
    for (const SurfaceRun& run : runs)
        edges += run.edges.size();
    if (edges > largestRunEdgeCount)
        return Error{ErrorKind::OutOfResource, "The isosurface has more than four thousand million vertices. Lower the "
                                               "accuracy of the mesh."};

    progress.report(0.6, extractingIsosurface);
    const SurfaceVertices vertices = numberVertices(runs, index, mesh.positions.size());
    if (progress.cancelled())
        return cancelledError(extractingIsosurface);
    progress.report(0.7, extractingIsosurface);
    TriangleMesh surface;
    const PlacingFindings found = placeVertices(mesh, gradients, vertices.edges, isovalue, surface);
    if (progress.cancelled())
        return cancelledError(extractingIsosurface);
    progress.report(0.9, extractingIsosurface);
    surface.triangles = joinTriangles(runs, vertices);
    if (!found.ties.empty())
        weldAtMeshVertices(found.ties, surface);
    if (found.normalsMissing)
        fillNormalsFromTriangles(surface);
    progress.report(1, extractingIsosurface);
    return surface;
}

Result<TriangleMesh> extractChecked(const TetrahedralMesh& mesh, const IsosurfaceIndex* index,
                                    std::span<const Eigen::Vector3f> gradients, double isovalue,
                                    const Progress& progress)
{
    if (Status status = checkArguments(mesh, index, gradients, isovalue); !status)
        return status.error();
    try {
        return extract(mesh, index, gradients, isovalue, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory for the isosurface. Close other programs or lower the accuracy of the mesh."};
    }
}

} // namespace

Result<TriangleMesh> extractIsosurface(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients,
                                       double isovalue, const Progress& progress)
{
    return extractChecked(mesh, nullptr, gradients, isovalue, progress);
}

Result<TriangleMesh> extractIsosurface(const TetrahedralMesh& mesh, const IsosurfaceIndex& index,
                                       std::span<const Eigen::Vector3f> gradients, double isovalue,
                                       const Progress& progress)
{
    return extractChecked(mesh, &index, gradients, isovalue, progress);
}

} // namespace tetra
