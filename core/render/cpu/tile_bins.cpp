// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/cpu/tile_bins.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace tetra {
namespace {

/// Chunks times tiles, so many counters at most.
constexpr std::size_t largestTable = 1 << 22;
constexpr std::size_t smallestChunk = 1 << 14;

std::size_t chunkCount(std::size_t triangles, std::size_t tiles)
{
    const std::size_t wanted = std::min<std::size_t>(64, (triangles + smallestChunk - 1) / smallestChunk);
    return std::max<std::size_t>(1, std::min(wanted, largestTable / tiles));
}

/// Calls visit(tile) for each tile that the triangle's bounding box touches.
template <class Visit>
void forEachTile(const DrawList& list, const ScreenTriangle& triangle, const TileGrid& grid, Visit&& visit)
{
    const SampleRectangle box = samplesUnder(list, triangle, {0, 0, grid.width, grid.height});
    if (box.width() <= 0 || box.height() <= 0)
        return;
    const int lastColumn = (box.right - 1) / grid.side;
    const int lastRow = (box.bottom - 1) / grid.side;
    for (int row = box.top / grid.side; row <= lastRow; ++row)
        for (int column = box.left / grid.side; column <= lastColumn; ++column)
            visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns()) +
                  static_cast<std::size_t>(column));
}

} // namespace

TileBins::TileBins(const DrawList& list, const TileGrid& grid) : first_(grid.count() + 1, 0)
{
    const std::size_t chunks = chunkCount(list.triangles.size(), grid.count());
    const auto chunkBegin = [&](std::size_t chunk) { return list.triangles.size() * chunk / chunks; };
    std::vector<std::vector<std::uint64_t>> places(chunks);
    tbb::parallel_for(std::size_t(0), chunks, [&](std::size_t chunk) {
        places[chunk].assign(grid.count(), 0);
        for (std::size_t t = chunkBegin(chunk); t < chunkBegin(chunk + 1); ++t)
            forEachTile(list, list.triangles[t], grid, [&](std::size_t tile) { ++places[chunk][tile]; });
    });
    std::uint64_t place = 0;
    for (std::size_t tile = 0; tile < grid.count(); ++tile) {
        first_[tile] = place;
        for (auto& ofChunk : places) {
            const std::uint64_t count = ofChunk[tile];
            ofChunk[tile] = place;
            place += count;
        }
    }
    first_.back() = place;
    triangles_.resize(place);
    tbb::parallel_for(std::size_t(0), chunks, [&](std::size_t chunk) {
        for (std::size_t t = chunkBegin(chunk); t < chunkBegin(chunk + 1); ++t)
            forEachTile(list, list.triangles[t], grid,
                        [&](std::size_t tile) { triangles_[places[chunk][tile]++] = static_cast<std::uint32_t>(t); });
    });
}

} // namespace tetra
