// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/cell_bins.h"

#include "core/graphics/volume/sample_box.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace tetra {
namespace {

constexpr std::size_t cellsInChunk = 1 << 15;
constexpr std::size_t cellsFetchedAhead = 24;

struct BoxedCell {
    std::uint32_t cell;
    std::int16_t left, top, right, bottom;
};

/// The cells of a chunk that may cover samples of the picture, and how many of them each tile has.
struct Chunk {
    Buffer<BoxedCell> cells;
    std::vector<std::uint32_t> places;
};

BinnedCell binned(const BoxedCell& boxed, int side, int row, int column)
{
    const int x = column * side, y = row * side;
    const auto byte = [](int number) { return static_cast<std::uint8_t>(number); };
    return {boxed.cell, byte(std::max(boxed.left - x, 0) / blockWidth), byte(std::max(boxed.top - y, 0) / blockHeight),
            byte((std::min(boxed.right - x, side) + blockWidth - 1) / blockWidth),
            byte((std::min(boxed.bottom - y, side) + blockHeight - 1) / blockHeight)};
}

} // namespace

CellBins binCells(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::span<const CellClass> classes,
                  std::span<const std::uint32_t> order, const ProjectedVertices& projected, const VolumeView& view,
                  const TileGrid& grid, const Progress& progress)
{
    const SampleRectangle picture{0, 0, grid.width, grid.height};
    const TileFinder finder(grid);
    const int side = grid.side;
    std::vector<Chunk> chunks((order.size() + cellsInChunk - 1) / cellsInChunk);
    tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t index) {
        Chunk& chunk = chunks[index];
        chunk.places.assign(grid.count(), 0);
        if (progress.cancelled())
            return;
        const auto ofChunk =
            order.subspan(index * cellsInChunk, std::min(cellsInChunk, order.size() - index * cellsInChunk));
        chunk.cells.resize(ofChunk.size());
        std::size_t count = 0;
        for (std::size_t i = 0; i < ofChunk.size(); ++i) {
            // Orders jump about; what the processor cannot guess is fetched ahead.
            const std::uint32_t ahead = ofChunk[std::min(i + cellsFetchedAhead, ofChunk.size() - 1)];
            __builtin_prefetch(&tetrahedra[ahead]);
            __builtin_prefetch(&classes[ahead]);
            const std::uint32_t cell = ofChunk[i];
            if (!classes[cell].visible())
                continue;
            const SampleRectangle box = intersection(boxOf(std::span(tetrahedra[cell]), projected, view), picture);
            if (isEmpty(box))
                continue;
            const auto place = [](int number) { return static_cast<std::int16_t>(number); };
            const BoxedCell boxed = {cell, place(box.left), place(box.top), place(box.right), place(box.bottom)};
            chunk.cells[count++] = boxed;
            forEachTileOf(box, finder, [&](int row, int column) { ++chunk.places[finder.numberOf(row, column)]; });
        }
        chunk.cells.resize(count);
    });

    CellBins bins;
    bins.first.push_back(0);
    for (std::size_t tile = 0; tile < grid.count(); ++tile) {
        // Places inside a tile fit 32 bits: it has every cell at most once.
        std::uint32_t place = 0;
        for (Chunk& chunk : chunks)
            place += std::exchange(chunk.places[tile], place);
        bins.first.push_back(bins.first.back() + place);
    }
    bins.cells.resize(bins.first.back());
    tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t index) {
        Chunk& chunk = chunks[index];
        for (const BoxedCell& boxed : chunk.cells)
            forEachTileOf({boxed.left, boxed.top, boxed.right, boxed.bottom}, finder, [&](int row, int column) {
                const std::size_t tile = finder.numberOf(row, column);
                bins.cells[bins.first[tile] + chunk.places[tile]++] = binned(boxed, side, row, column);
            });
    });
    return bins;
}

} // namespace tetra
