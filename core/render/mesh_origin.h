// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

namespace tetra {

/// By its bits: for sources that are compiled as if all numbers were finite, and for those that may share code with
/// them.
inline bool isFiniteByBits(double number) noexcept
{
    constexpr std::uint64_t exponent = 0x7ff;
    return (std::bit_cast<std::uint64_t>(number) >> 52 & exponent) != exponent;
}
inline bool isFiniteByBits(float number) noexcept
{
    constexpr std::uint32_t exponent = 0xff;
    return (std::bit_cast<std::uint32_t>(number) >> 23 & exponent) != exponent;
}

/// What the positions of a mesh are told relative to where they become floats, which far from zero would be too coarse:
/// the first that is finite, zero if none is. O(n).
inline Eigen::Vector3d meshOrigin(std::span<const Eigen::Vector3d> positions)
{
    const auto isFinite = [](const Eigen::Vector3d& position) {
        return isFiniteByBits(position.x()) && isFiniteByBits(position.y()) && isFiniteByBits(position.z());
    };
    const auto finite = std::ranges::find_if(positions, isFinite);
    return finite == positions.end() ? Eigen::Vector3d(0, 0, 0) : *finite;
}

} // namespace tetra
