// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace tetra {

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
