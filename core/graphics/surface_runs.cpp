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

/// A tetrahedron that the surface crosses: where it is among others, times 16, plus its marching case.
using Crossed = std::uint32_t;

/// Written always and kept only if crossed: cheaper than a branch that is hard to predict.
std::size_t findCrossed(std::span<const Cell> cells, const std::uint8_t* inside, Crossed* found)
{
    std::size_t size = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto& [a, b, c, d] = cells[i];
        const unsigned bits = static_cast<unsigned>(inside[a] | inside[b] << 1 | inside[c] << 2 | inside[d] << 3);
        found[size] = static_cast<Crossed>(i << 4 | bits);
        size += bits - 1u < 14u ? 1 : 0;
    }
    return size;
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
        std::array<Crossed, rangedChunkSize> crossed;
        const std::size_t count = findCrossed(cells, inside_, crossed.data());
        edges_.reserve(4 * count);
        std::size_t size = triangles_.size();
        triangles_.resize(size + 2 * count);
        for (std::size_t i = 0; i < count; ++i) {
            const Cell& cell = cells[crossed[i] / 16];
            const MarchingCase& marching = marchingCases[crossed[i] % 16];
            std::array<std::uint32_t, 4> corners{};
            for (std::size_t corner = 0; corner < static_cast<std::size_t>(marching.corners); ++corner) {
                const std::uint32_t a = cell[marching.edges[corner][0]];
                const std::uint32_t b = cell[marching.edges[corner][1]];
                corners[corner] = edges_.numberOf(EdgeKey(std::min(a, b)) << 32 | std::max(a, b));
            }
            triangles_[size++] = {corners[0], corners[1], corners[2]};
            triangles_[size] = {corners[0], corners[2], corners[3]};
            size += marching.corners == 4 ? 1 : 0;
        }
        triangles_.resize(size);
    }

    const TetrahedralMesh& mesh_;
    const std::uint8_t* inside_;
    EdgeTable edges_;
    Buffer<std::array<std::uint32_t, 3>> triangles_;
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
