// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/base/progress.h"
#include "core/graphics/cpu/tile_grid.h"
#include "core/graphics/volume/cell_classes.h"
#include "core/graphics/volume/projected_vertices.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Samples are drawn in blocks of this shape, the lanes of a vector.
inline constexpr int blockWidth = 4;
inline constexpr int blockHeight = 2;

/// A cell in a tile, and the blocks of the tile that it may cover: columns [left, right), rows [top, bottom).
struct BinnedCell {
    std::uint32_t cell;
    std::uint8_t left, top, right, bottom;
};

/// What each tile may show, front to back.
struct CellBins {
    std::vector<std::uint64_t> first; ///< for each tile the place of its first cell, and after the last tile the end
    Buffer<BinnedCell> cells;

    std::span<const BinnedCell> cellsOf(std::size_t tile) const noexcept
    {
        return std::span(cells).subspan(first[tile], first[tile + 1] - first[tile]);
    }
};

/// Deals the cells of `order` that are visible by class to the tiles whose samples their boxes hold. The grid's tiles
/// have at most 255 blocks a side. O(cells + entries), on all threads of the current arena, the same result with any
/// number. Incomplete if cancelled. May throw std::bad_alloc.
CellBins binCells(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::span<const CellClass> classes,
                  std::span<const std::uint32_t> order, const ProjectedVertices& projected, const VolumeView& view,
                  const TileGrid& grid, const Progress& progress);

} // namespace tetra
