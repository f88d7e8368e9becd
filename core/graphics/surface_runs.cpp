// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/surface_runs.h"

#include "core/graphics/crossed_edges.h"
#include "core/graphics/crossed_tetrahedra.h"
#include "core/graphics/edge_table.h"
#include "core/graphics/marching_cases.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace tetra {
namespace {

using RunCorners = std::array<std::uint32_t, 4>;
using Triangle = std::array<std::uint32_t, 3>;

/// Crossed tetrahedra that are marched through step by step together: what lies between the steps stays in the nearest
/// cache.
constexpr std::size_t marchedTogether = 64;

/// Two triangles always, of which the second counts if the piece has four corners.
Triangle* writeTriangles(std::span<const CrossedTetrahedron> crossed, const std::uint32_t* corners, Triangle* triangles)
{
    for (const CrossedTetrahedron one : crossed) {
        const int count = marchingCases[one % 16].corners;
        triangles[0] = {corners[0], corners[1], corners[2]};
        triangles[1] = {corners[0], corners[2], corners[3]};
        corners += count;
        triangles += count - 2;
    }
    return triangles;
}

/// What a thread keeps from run to run.
class Marcher {
public:
    Marcher(const TetrahedralMesh& mesh, const VertexSides& sides)
        : mesh_(mesh), sides_(sides), crossed_(surfaceRunSize + crossedTetrahedronRoom)
    {
    }

    /// Makes the surface in the chunks from `first` on that `isCrossed` tells.
    template <class IsCrossed> SurfaceRun march(std::size_t first, std::size_t end, IsCrossed&& isCrossed)
    {
        const std::span run = std::span(mesh_.tetrahedra).subspan(first, end - first);
        const std::span crossed = findCrossedIn(run, first / rangedChunkSize, isCrossed);
        edges_.clear(crossed.size() * 3 / 4);
        Buffer<Triangle> triangles(2 * crossed.size());
        Triangle* next = triangles.data();
        for (std::size_t i = 0; i < crossed.size(); i += marchedTogether)
            next = marchSome(run, crossed.subspan(i, std::min(marchedTogether, crossed.size() - i)), next);
        triangles.resize(static_cast<std::size_t>(next - triangles.data()));
        return {{edges_.keys().begin(), edges_.keys().end()}, std::move(triangles)};
    }

private:
    /// Chunks that are passed over stop the processor from fetching ahead itself.
    static constexpr std::size_t chunksAhead = 4;

    /// Lists the chunks to look at first, so that what is fetched is one of them.
    template <class IsCrossed> std::span<const CrossedTetrahedron>
    findCrossedIn(std::span<const RunCorners> run, std::size_t firstChunk, IsCrossed&& isCrossed)
    {
        const std::size_t chunkCount = (run.size() + rangedChunkSize - 1) / rangedChunkSize;
        std::array<std::uint32_t, surfaceRunSize / rangedChunkSize + chunksAhead> chunks; // their first tetrahedra
        std::size_t count = 0;
        for (std::size_t chunk = 0; chunk < chunkCount; ++chunk) {
            chunks[count] = static_cast<std::uint32_t>(chunk * rangedChunkSize);
            count += isCrossed(firstChunk + chunk) ? 1 : 0;
        }
        std::fill_n(chunks.begin() + static_cast<std::ptrdiff_t>(count), chunksAhead, 0u);
        CrossedTetrahedron* last = crossed_.data();
        for (std::size_t i = 0; i < count; ++i) {
            const RunCorners* next = run.data() + chunks[i + chunksAhead];
            for (std::size_t t = 0; t < rangedChunkSize; t += 4)
                __builtin_prefetch(next + t);
            last = findCrossed(run.subspan(chunks[i], std::min(rangedChunkSize, run.size() - chunks[i])), chunks[i],
                               sides_, last);
        }
        return {crossed_.data(), last};
    }

    Triangle* marchSome(std::span<const RunCorners> run, std::span<const CrossedTetrahedron> crossed,
                        Triangle* triangles)
    {
        std::array<EdgeKey, 4 * marchedTogether> edges;
        std::array<std::uint32_t, 4 * marchedTogether> numbers;
        const auto count = static_cast<std::size_t>(writeCrossedEdges(run, crossed, edges.data()) - edges.data());
        auto numbering = edges_.begin(count);
        for (std::size_t i = 0; i < count; ++i)
            numbers[i] = numbering.numberOf(edges[i]);
        edges_.end(numbering);
        return writeTriangles(crossed, numbers.data(), triangles);
    }

    const TetrahedralMesh& mesh_;
    const VertexSides& sides_;
    Buffer<CrossedTetrahedron> crossed_;
    EdgeTable edges_;
};

} // namespace

std::vector<SurfaceRun> makeSurfaceRuns(const TetrahedralMesh& mesh, const IsosurfaceIndex* index, double isovalue,
                                        const Progress& progress)
{
    const VertexSides sides(mesh.values, isovalue);
    const std::size_t total = mesh.tetrahedra.size();
    std::vector<SurfaceRun> runs((total + surfaceRunSize - 1) / surfaceRunSize);
    tbb::enumerable_thread_specific<Marcher> marchers([&] { return Marcher(mesh, sides); });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, runs.size(), 1), [&](const auto& range) {
        Marcher& marcher = marchers.local();
        for (std::size_t run = range.begin(); run != range.end() && !progress.cancelled(); ++run)
            runs[run] = marcher.march(
                run * surfaceRunSize, std::min(total, (run + 1) * surfaceRunSize),
                [&](std::size_t chunk) { return index == nullptr || index->ranges[chunk].crossedAt(isovalue); });
    });
    return runs;
}

} // namespace tetra
