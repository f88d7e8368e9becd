// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cells/point_welding.h"

#include <bit>
#include <numeric>

namespace tetra {

namespace {

std::uint64_t hashOf(const Eigen::Vector3d& position)
{
    std::uint64_t hash = 0;
    for (const double coordinate : position) {
        hash ^= std::bit_cast<std::uint64_t>(coordinate + 0.0); // -0 and 0 are the same place
        hash *= 0x9e3779b97f4a7c15;
        hash ^= hash >> 32;
    }
    return hash * 0xbf58476d1ce4e5b9;
}

} // namespace

std::vector<std::uint32_t> firstOnPlace(std::span<const Eigen::Vector3d> positions, const std::vector<bool>& used)
{
    constexpr std::uint32_t nobody = 0xffffffff;
    std::vector<std::uint32_t> first(positions.size());
    std::iota(first.begin(), first.end(), 0);
    const std::uint64_t room = std::bit_ceil(positions.size() + positions.size() / 2 + 2);
    const int shift = 64 - std::countr_zero(room);
    std::vector<std::uint32_t> table(room, nobody);
    for (std::uint32_t point = 0; point < positions.size(); ++point) {
        if (!used[point])
            continue;
        std::uint64_t place = hashOf(positions[point]) >> shift;
        while (table[place] != nobody && positions[table[place]] != positions[point])
            place = (place + 1) & (room - 1);
        if (table[place] == nobody)
            table[place] = point;
        first[point] = table[place];
    }
    return first;
}

} // namespace tetra
