// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/crossed_tetrahedra.h"

#include "core/base/buffer.h"
#include "core/graphics/marching_cases.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace tetra {
namespace {

/// A byte a vertex: four times smaller than the values, so that the gathers below hit the cache more often.
Buffer<std::uint8_t> classifyVertices(const TetrahedralMesh& mesh, double isovalue)
{
    Buffer<std::uint8_t> inside(mesh.values.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, inside.size(), 1 << 15), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v)
            inside[v] = static_cast<double>(mesh.values[v]) >= isovalue ? 1 : 0;
    });
    return inside;
}

CrossedChunk findInChunk(const TetrahedralMesh& mesh, const std::uint8_t* inside, std::size_t first, std::size_t count,
                         Buffer<std::uint32_t>& found)
{
    found.resize(count);
    CrossedChunk chunk;
    std::size_t size = 0;
    for (std::size_t offset = 0; offset < count; ++offset) {
        const auto& [a, b, c, d] = mesh.tetrahedra[first + offset];
        const unsigned bits = static_cast<unsigned>(inside[a] | inside[b] << 1 | inside[c] << 2 | inside[d] << 3);
        // Written always and kept only if crossed: cheaper than a branch that is hard to predict.
        found[size] = static_cast<std::uint32_t>(offset << 4 | bits);
        size += bits - 1u < 14u ? 1 : 0;
    }
    chunk.entries.assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(size));
    for (const std::uint32_t entry : chunk.entries)
        chunk.corners += static_cast<std::uint64_t>(marchingCases[CrossedChunk::caseOf(entry)].corners);
    return chunk;
}

} // namespace

std::vector<CrossedChunk> findCrossedTetrahedra(const TetrahedralMesh& mesh, double isovalue, const Progress& progress)
{
    const Buffer<std::uint8_t> inside = classifyVertices(mesh, isovalue);
    const std::size_t total = mesh.tetrahedra.size();
    std::vector<CrossedChunk> chunks((total + CrossedChunk::chunkSize - 1) / CrossedChunk::chunkSize);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks.size()), [&](const auto& range) {
        Buffer<std::uint32_t> found;
        for (std::size_t c = range.begin(); c != range.end() && !progress.cancelled(); ++c) {
            const std::size_t first = c * CrossedChunk::chunkSize;
            chunks[c] =
                findInChunk(mesh, inside.data(), first, std::min(CrossedChunk::chunkSize, total - first), found);
        }
    });
    return chunks;
}

} // namespace tetra
