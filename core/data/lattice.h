// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>

namespace tetra {

/// A regular grid of points: point (i, j, k) lies at origin + (i, j, k) * spacing. The first index runs fastest.
/// Every axis has at least two points and a positive finite spacing (readers refuse anything else).
struct Lattice {
    std::array<std::uint32_t, 3> size{2, 2, 2};
    Eigen::Vector3d spacing{1, 1, 1};
    Eigen::Vector3d origin{0, 0, 0};

    std::uint64_t pointCount() const noexcept { return std::uint64_t(size[0]) * size[1] * size[2]; }
    std::uint64_t cellCount() const noexcept { return std::uint64_t(size[0] - 1) * (size[1] - 1) * (size[2] - 1); }

    std::uint64_t index(std::uint32_t i, std::uint32_t j, std::uint32_t k) const noexcept
    {
        return (std::uint64_t(k) * size[1] + j) * size[0] + i;
    }
    std::array<std::uint32_t, 3> coordinates(std::uint64_t index) const noexcept
    {
        return {static_cast<std::uint32_t>(index % size[0]), static_cast<std::uint32_t>(index / size[0] % size[1]),
                static_cast<std::uint32_t>(index / size[0] / size[1])};
    }
    Eigen::Vector3d position(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
    {
        return origin + spacing.cwiseProduct(Eigen::Vector3d(i, j, k));
    }
    Eigen::AlignedBox3d bounds() const { return {origin, position(size[0] - 1, size[1] - 1, size[2] - 1)}; }
};

} // namespace tetra
