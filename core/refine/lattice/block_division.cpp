// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/block_division.h"

#include <algorithm>
#include <cstddef>

namespace tetra {

BlockDivision::BlockDivision(const std::array<std::uint32_t, 3>& size, std::uint32_t edge) : size_(size)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t cells = size[axis] - 1;
        edges_[axis] = edge == 0 ? cells : std::min(edge, cells);
        counts_[axis] = (cells + edges_[axis] - 1) / edges_[axis];
    }
}

std::array<std::uint32_t, 3> BlockDivision::place(std::uint32_t block) const
{
    return {block % counts_[0], block / counts_[0] % counts_[1], block / counts_[0] / counts_[1]};
}

LatticeBox BlockDivision::box(std::uint32_t block) const
{
    const std::array<std::uint32_t, 3> at = place(block);
    LatticeBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.origin[axis] = at[axis] * edges_[axis];
        box.size[axis] = std::min(edges_[axis], size_[axis] - 1 - box.origin[axis]) + 1;
    }
    return box;
}

bool BlockDivision::odd(std::uint32_t block) const
{
    const std::array<std::uint32_t, 3> at = place(block);
    return (at[0] + at[1] + at[2]) % 2 == 1;
}

void BlockDivision::blocksOf(const std::array<std::uint32_t, 3>& point, std::vector<std::uint32_t>& blocks) const
{
    std::array<std::uint32_t, 3> from{}, to{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        to[axis] = std::min(point[axis] / edges_[axis], counts_[axis] - 1);
        from[axis] = to[axis] > 0 && point[axis] == to[axis] * edges_[axis] ? to[axis] - 1 : to[axis];
    }
    blocks.clear();
    for (std::uint32_t z = from[2]; z <= to[2]; ++z)
        for (std::uint32_t y = from[1]; y <= to[1]; ++y)
            for (std::uint32_t x = from[0]; x <= to[0]; ++x)
                blocks.push_back((z * counts_[1] + y) * counts_[0] + x);
}

std::optional<std::uint32_t> edgeOfBlocks(const std::array<std::uint32_t, 3>& size,
                                          std::span<const std::uint32_t> corners)
{
    const auto placeOf = [&](std::uint32_t point) -> std::array<std::uint32_t, 3> {
        return {point % size[0], point / size[0] % size[1], point / size[0] / size[1]};
    };
    // Blocks of the same edge, but for the last: the least coordinate behind the first plane of any axis that is cut.
    std::uint32_t edge = 0;
    for (const std::uint32_t point : corners) {
        const auto place = placeOf(point);
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (place[axis] > 0 && place[axis] + 1 < size[axis] && (edge == 0 || place[axis] < edge))
                edge = place[axis];
    }
    const BlockDivision division(size, edge);
    std::uint64_t count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
        count *= division.countAlong(axis) + 1ull;
    const bool areCorners = corners.size() == count && std::ranges::all_of(corners, [&](std::uint32_t point) {
                                const auto place = placeOf(point);
                                return division.isBorder(0, place[0]) && division.isBorder(1, place[1]) &&
                                       place[2] < size[2] && division.isBorder(2, place[2]);
                            });
    return areCorners ? std::optional(edge) : std::nullopt;
}

} // namespace tetra
