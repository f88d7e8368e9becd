// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/surface_runs.h"

#include "core/base/simd.h"
#include "core/graphics/edge_table.h"
#include "core/graphics/marching_cases.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {
namespace {

using Cell = std::array<std::uint32_t, 4>;
using Triangle = std::array<std::uint32_t, 3>;

/// Chunks that are passed over stop the processor from fetching ahead itself.
constexpr std::size_t fetchedAhead = 64;

/// The smallest float that is inside.
float smallestInside(double isovalue)
{
    const auto nearest = static_cast<float>(isovalue);
    return static_cast<double>(nearest) >= isovalue ? nearest
                                                    : std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

TETRA_SIMD_CLONES void classify(const float* values, std::size_t count, float threshold, std::uint8_t* inside)
{
    for (std::size_t v = 0; v < count; ++v)
        inside[v] = values[v] >= threshold ? 1 : 0;
}

/// A byte a vertex: four times smaller than the values, so that the gathers below hit the cache more often.
Buffer<std::uint8_t> classifyVertices(const TetrahedralMesh& mesh, double isovalue)
{
    const float threshold = smallestInside(isovalue);
    Buffer<std::uint8_t> inside(mesh.values.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, inside.size(), 1 << 15), [&](const auto& range) {
        classify(&mesh.values[range.begin()], range.size(), threshold, &inside[range.begin()]);
    });
    return inside;
}

/// A tetrahedron that the surface crosses: where it is in its chunk, times 16, plus its marching case.
using Crossed = std::uint32_t;

/// Those of a chunk, by how many corners their piece of the surface has.
struct CrossedChunk {
    std::array<Crossed, rangedChunkSize + 1> triangles;
    std::array<Crossed, rangedChunkSize + 1> quadrilaterals;
    std::size_t triangleCount = 0;
    std::size_t quadrilateralCount = 0;
};

/// Written always and kept only if crossed: cheaper than a branch that is hard to predict.
void findCrossed(std::span<const Cell> cells, const std::uint8_t* inside, CrossedChunk& found)
{
    constexpr unsigned threeCorners = 0b0110100110010110; // a bit for each case: one corner inside, or three
    std::size_t triangles = 0, both = 0;
    constexpr unsigned crossing = 0b0111111111111110;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        __builtin_prefetch(cells.data() + i + fetchedAhead);
        const auto& [a, b, c, d] = cells[i];
        const unsigned bits = static_cast<unsigned>(inside[a] | inside[b] << 1 | inside[c] << 2 | inside[d] << 3);
        const auto crossed = static_cast<Crossed>(i << 4 | bits);
        found.triangles[triangles] = crossed;
        found.quadrilaterals[both - triangles] = crossed;
        both += crossing >> bits & 1;
        triangles += threeCorners >> bits & 1;
    }
    found.triangleCount = triangles;
    found.quadrilateralCount = both - triangles;
}

/// What a thread keeps from run to run.
class Marcher {
public:
    Marcher(const TetrahedralMesh& mesh, const std::uint8_t* inside) : mesh_(mesh), inside_(inside) {}

    /// Makes the surface in the chunks from `first` on that `isCrossed` tells.
    template <class IsCrossed> SurfaceRun march(std::size_t first, std::size_t end, IsCrossed&& isCrossed)
    {
        edges_.clear();
        triangles_.clear();
        for (std::size_t begin = first; begin < end; begin += rangedChunkSize)
            if (isCrossed(begin / rangedChunkSize))
                marchChunk(std::span(mesh_.tetrahedra).subspan(begin, std::min(rangedChunkSize, end - begin)));
        return {{edges_.keys().begin(), edges_.keys().end()}, {triangles_.begin(), triangles_.end()}};
    }

private:
    void marchChunk(std::span<const Cell> cells)
    {
        CrossedChunk crossed;
        findCrossed(cells, inside_, crossed);
        auto edges = edges_.begin(3 * crossed.triangleCount + 4 * crossed.quadrilateralCount);
        const std::size_t size = triangles_.size();
        triangles_.resize(size + crossed.triangleCount + 2 * crossed.quadrilateralCount);
        Triangle* next = triangles_.data() + size;
        for (std::size_t i = 0; i < crossed.triangleCount; ++i)
            *next++ = cornersOf<3>(cells, crossed.triangles[i], edges);
        for (std::size_t i = 0; i < crossed.quadrilateralCount; ++i) {
            const auto [a, b, c, d] = cornersOf<4>(cells, crossed.quadrilaterals[i], edges);
            *next++ = {a, b, c};
            *next++ = {a, c, d};
        }
        edges_.end(edges);
    }

    template <std::size_t count> static std::array<std::uint32_t, count>
    cornersOf(std::span<const Cell> cells, Crossed crossed, EdgeTable::Numbering& edges)
    {
        const Cell& cell = cells[crossed / 16];
        const MarchingCase& marching = marchingCases[crossed % 16];
        std::array<std::uint32_t, count> corners;
        for (std::size_t corner = 0; corner < count; ++corner) {
            const std::uint32_t a = cell[marching.edges[corner][0]];
            const std::uint32_t b = cell[marching.edges[corner][1]];
            corners[corner] = edges.numberOf(EdgeKey(std::min(a, b)) << 32 | std::max(a, b));
        }
        return corners;
    }

    const TetrahedralMesh& mesh_;
    const std::uint8_t* inside_;
    EdgeTable edges_;
    Buffer<Triangle> triangles_;
};

} // namespace

std::vector<SurfaceRun> makeSurfaceRuns(const TetrahedralMesh& mesh, const IsosurfaceIndex* index, double isovalue,
                                        const Progress& progress)
{
    const Buffer<std::uint8_t> inside = classifyVertices(mesh, isovalue);
    const std::size_t total = mesh.tetrahedra.size();
    std::vector<SurfaceRun> runs((total + surfaceRunSize - 1) / surfaceRunSize);
    tbb::enumerable_thread_specific<Marcher> marchers([&] { return Marcher(mesh, inside.data()); });
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
