// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tetra {

/// A box of points in a larger lattice.
struct LatticeBox {
    std::array<std::uint32_t, 3> origin{0, 0, 0}; ///< its first point
    std::array<std::uint32_t, 3> size{2, 2, 2};   ///< points along each axis

    std::uint32_t last(std::size_t axis) const noexcept { return origin[axis] + size[axis] - 1; }
    /// Corner 0 to 7: the bits of its number choose the last point along x, y and z.
    std::array<std::uint32_t, 3> corner(std::uint32_t number) const noexcept
    {
        return {(number & 1) != 0 ? last(0) : origin[0], (number >> 1 & 1) != 0 ? last(1) : origin[1],
                (number >> 2 & 1) != 0 ? last(2) : origin[2]};
    }
    std::uint64_t pointCount() const noexcept { return std::uint64_t(size[0]) * size[1] * size[2]; }
};

} // namespace tetra
