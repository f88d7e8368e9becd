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
    explicit DisjointSets(std::size_t count = 0) { reset(count); }

    /// Each of the numbers below `count` in a set of its own.
    void reset(std::size_t count)
    {
        parents_.resize(count);
        std::iota(parents_.begin(), parents_.end(), 0u);
    }
    /// The next number, in a set of its own.
    void add() { parents_.push_back(static_cast<std::uint32_t>(parents_.size())); }
    std::size_t size() const noexcept { return parents_.size(); }

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
