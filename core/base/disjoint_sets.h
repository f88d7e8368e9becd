// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace tetra {

/// Numbers in sets that are joined; the smallest number of a set is its root. Nearly O(1) each.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }

    std::uint32_t root(std::uint32_t number)
    {
        while (parents_[number] != number) {
            parents_[number] = parents_[parents_[number]];
            number = parents_[number];
        }
        return number;
    }
    void join(std::uint32_t first, std::uint32_t second)
    {
        first = root(first);
        second = root(second);
        if (first > second)
            std::swap(first, second);
        parents_[second] = first;
    }

private:
    std::vector<std::uint32_t> parents_;
};

} // namespace tetra
