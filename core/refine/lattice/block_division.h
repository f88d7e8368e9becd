// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/lattice/packed_lattice.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// A lattice cut into blocks of equal size that share their faces (R10); the last along an axis may be smaller.
class BlockDivision {
public:
    /// `edge`: the cells along an edge of a block; 0 for one block. `size`: the lattice's points, at least two an axis.
    BlockDivision(const std::array<std::uint32_t, 3>& size, std::uint32_t edge);

    /// How many blocks lie along an axis.
    std::uint32_t countAlong(std::size_t axis) const noexcept { return counts_[axis]; }
    /// The block along an axis that has the cells from a point on; of the last point, those before it.
    std::uint32_t blockAlong(std::size_t axis, std::uint32_t coordinate) const noexcept
    {
        return std::min(coordinate / edges_[axis], counts_[axis] - 1);
    }
    /// Whether a plane of points across an axis bounds blocks.
    bool isBorder(std::size_t axis, std::uint32_t coordinate) const noexcept
    {
        return coordinate % edges_[axis] == 0 || coordinate == size_[axis] - 1;
    }
    const std::array<std::uint32_t, 3>& size() const noexcept { return size_; }
    /// The cells of a block along each axis, but for the last ones. All 0 if there is but one block: HistoryTraits.
    std::array<std::uint32_t, 3> blockCells() const noexcept
    {
        return count() > 1 ? edges_ : std::array<std::uint32_t, 3>{};
    }

    std::uint32_t count() const noexcept { return counts_[0] * counts_[1] * counts_[2]; }
    LatticeBox box(std::uint32_t block) const;
    /// Of two blocks that share a face one is odd: their starts then cut the face along the same diagonal.
    bool odd(std::uint32_t block) const;
    /// The blocks that have a point, eight at most, in rising order.
    void blocksOf(const std::array<std::uint32_t, 3>& point, std::vector<std::uint32_t>& blocks) const;

private:
    std::array<std::uint32_t, 3> place(std::uint32_t block) const;

    std::array<std::uint32_t, 3> size_;
    std::array<std::uint32_t, 3> edges_{};
    std::array<std::uint32_t, 3> counts_{};
};

/// The cells along an edge of the blocks (0 for one block) whose corners are these points of a lattice, by their
/// numbers, each once; nothing if they are not the corners of any.
std::optional<std::uint32_t> edgeOfBlocks(const std::array<std::uint32_t, 3>& size,
                                          std::span<const std::uint32_t> corners);

} // namespace tetra
