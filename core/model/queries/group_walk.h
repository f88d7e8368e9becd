// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/model.h"

#include <cstdint>

namespace tetra {

/// The sites [first, end) of one group: a set of sites that is to have a mesh takes them all or none (FORMAT.md).
struct GroupOfSites {
    std::uint32_t first;
    std::uint32_t end;
};

inline GroupOfSites groupOf(const Model& model, std::uint32_t site)
{
    const std::span<const std::uint8_t> goesOn = model.groupGoesOn();
    GroupOfSites group{site, site + 1};
    while (group.first > 0 && goesOn[group.first - 1] != 0)
        --group.first;
    while (group.end < goesOn.size() && goesOn[group.end - 1] != 0)
        ++group.end;
    return group;
}

/// By how many tetrahedra the group makes a mesh larger. Modulo 2^64: it may make it smaller.
inline std::uint64_t growthBy(const Model& model, const GroupOfSites& group)
{
    const std::span<const std::uint32_t> sizes = model.meshSizes();
    return std::uint64_t(sizes[group.end - 1]) - (group.first > 0 ? sizes[group.first - 1] : 0);
}

} // namespace tetra
