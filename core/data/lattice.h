// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <string_view>

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

/// What kind of domain the points of a dataset lie in (R1). The numbers are part of the `.tan` format.
enum class DomainClass : std::uint32_t { RegularLattice = 0, Curvilinear = 1, Irregular = 2, Scattered = 3 };

constexpr std::string_view domainClassName(DomainClass domain) noexcept
{
    constexpr std::string_view names[] = {"regular", "curvilinear", "irregular", "scattered"};
    return names[static_cast<std::uint32_t>(domain)];
}

/// Whether the points are those of a lattice of computational space.
constexpr bool isOnLattice(DomainClass domain) noexcept
{
    return domain == DomainClass::RegularLattice || domain == DomainClass::Curvilinear;
}

/// Whether a mesh of fewer points can fill another space than the data do (R4).
constexpr bool canWarp(DomainClass domain) noexcept
{
    return domain == DomainClass::Curvilinear || domain == DomainClass::Irregular;
}

} // namespace tetra
