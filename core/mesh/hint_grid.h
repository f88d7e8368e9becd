// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/mesh/block_division.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// The points of a divided lattice in small cells, none of which reaches into two blocks: a number is kept for each,
/// that of a tetrahedron thereabouts. A point on the border of blocks belongs to a cell of each.
class HintGrid {
public:
    static constexpr std::uint32_t none = 0xffffffff;

    HintGrid() = default;
    /// A cell has `edge` lattice cells along each axis, or fewer. All hints are none.
    HintGrid(const BlockDivision& division, std::uint32_t edge);

    std::uint32_t cellCount() const noexcept { return static_cast<std::uint32_t>(hints_.size()); }
    /// One of the cells that have the point.
    std::uint32_t cellOf(std::uint32_t x, std::uint32_t y, std::uint32_t z) const noexcept
    {
        return axes_[0].cells[x] + axes_[1].cells[y] + axes_[2].cells[z];
    }
    /// One cell for each block that has the point, eight at most, in rising order of the blocks; how many.
    std::uint32_t cellsOf(const std::array<std::uint32_t, 3>& point,
                          std::array<std::uint32_t, 8>& cells) const noexcept;
    /// The first and the last point along an axis of the block that a cell lies in.
    struct Bounds {
        std::int32_t first = 0;
        std::int32_t last = 0;
    };
    std::array<Bounds, 3> blockOf(std::uint32_t cell) const noexcept;
    bool dividesBlocks() const noexcept { return dividesBlocks_; }

    std::uint32_t& operator[](std::uint32_t cell) noexcept { return hints_[cell]; }
    std::uint32_t operator[](std::uint32_t cell) const noexcept { return hints_[cell]; }
    void prefetch(std::uint32_t cell) const { __builtin_prefetch(&hints_[cell]); }

    /// Gives each cell without a hint that of a cell near it in its block, if there is any in the block.
    void spread();

private:
    struct Axis {
        std::vector<std::uint32_t> cells;      ///< of each point, times the stride
        std::vector<std::uint32_t> cellsBelow; ///< likewise in the block before, on a border; else the same
        std::vector<Bounds> blocks;            ///< of each cell
        std::uint32_t stride = 1;
    };

    std::array<Axis, 3> axes_;
    bool dividesBlocks_ = false;
    Buffer<std::uint32_t> hints_;
};

} // namespace tetra
