// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/isosurface/isosurface.h"

#include "core/base/simd.h"
#include "core/render/isosurface/surface_chunks.h"

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>
#include <string>
#include <unordered_map>

namespace tetra {

namespace {

/// Calls visit(vertex, run) for each corner, on all threads.
template <class Visit> void forEachCorner(const TetrahedralMesh& mesh, Visit&& visit)
{
    const std::size_t count = mesh.tetrahedra.size();
    tbb::parallel_for(std::size_t(0), (count + surfaceChunkSize - 1) / surfaceChunkSize, [&](std::size_t run) {
        for (std::size_t t = run * surfaceChunkSize; t < std::min(count, (run + 1) * surfaceChunkSize); ++t)
            for (const std::uint32_t vertex : mesh.tetrahedra[t])
                visit(vertex, static_cast<std::uint32_t>(run));
    });
}

} // namespace

IsosurfaceIndex makeIsosurfaceIndex(const TetrahedralMesh& mesh)
{
    IsosurfaceIndex index;
    index.ranges = chunkRanges(mesh);
    // Whichever run of several comes last, another one sees that it is not alone.
    Buffer<std::uint32_t> runs(mesh.positions.size());
    index.inOneRun.assign(mesh.positions.size(), 1);
    forEachCorner(mesh, [&](std::uint32_t vertex, std::uint32_t run) {
        std::atomic_ref(runs[vertex]).store(run, std::memory_order_relaxed);
    });
    forEachCorner(mesh, [&](std::uint32_t vertex, std::uint32_t run) {
        if (std::atomic_ref(runs[vertex]).load(std::memory_order_relaxed) != run)
            std::atomic_ref(index.inOneRun[vertex]).store(0, std::memory_order_relaxed);
    });
    return index;
}

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

Buffer<Triangle> joinTriangles(std::span<const SurfaceChunk> runs, const SurfaceVertices& vertices)
{
    std::vector<std::size_t> first(1, 0);
    for (const SurfaceChunk& run : runs)
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
    const std::vector<SurfaceChunk> runs = makeSurfaceChunks(mesh, index, isovalue, progress);
    if (progress.cancelled())
        return cancelledError(extractingIsosurface);
    std::uint64_t edges = 0;
    for (const SurfaceChunk& run : runs)
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

namespace {

/// The unit vector of a direction, or zero if it has none. Scaled first, so that no square overflows or vanishes.
Eigen::Vector3f unitOrZero(const Eigen::Vector3d& direction)
{
    const double largest = direction.cwiseAbs().maxCoeff();
    if (!(largest > 0) || !direction.allFinite())
        return Eigen::Vector3f::Zero();
    return (direction / largest).normalized().cast<float>();
}

} // namespace

void fillNormalsFromTriangles(TriangleMesh& surface)
{
    std::unordered_map<std::uint32_t, Eigen::Vector3d> sums;
    for (std::size_t v = 0; v < surface.normals.size(); ++v)
        if (surface.normals[v].isZero(0))
            sums.emplace(static_cast<std::uint32_t>(v), Eigen::Vector3d::Zero());
    for (const auto& triangle : surface.triangles) {
        const Eigen::Vector3d corner = surface.positions[triangle[0]].cast<double>();
        const Eigen::Vector3d normal = (surface.positions[triangle[1]].cast<double>() - corner)
                                           .cross(surface.positions[triangle[2]].cast<double>() - corner);
        for (const std::uint32_t vertex : triangle)
            if (const auto sum = sums.find(vertex); sum != sums.end())
                sum->second += normal;
    }
    for (const auto& [vertex, sum] : sums) {
        const Eigen::Vector3f normal = unitOrZero(sum);
        surface.normals[vertex] = normal.isZero(0) ? Eigen::Vector3f::UnitZ() : normal;
    }
}

} // namespace tetra
