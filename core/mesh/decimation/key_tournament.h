// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetra {

/// The largest of many numbers, none below 0, that change one at a time: a binary tree of maxima.
class KeyTournament {
public:
    /// All are 0. May throw std::bad_alloc.
    explicit KeyTournament(std::size_t count)
        : first_(std::bit_ceil(std::max<std::size_t>(count, 1))), nodes_(2 * first_)
    {
    }

    /// O(log count) at worst, a few steps where the number is far from the largest.
    void set(std::size_t index, float key)
    {
        std::size_t node = first_ + index;
        while (nodes_[node] != key) {
            nodes_[node] = key;
            if (node == 1)
                return;
            key = std::max(key, nodes_[node ^ 1]);
            node >>= 1;
        }
    }
    float largest() const noexcept { return nodes_[1]; }

private:
    std::size_t first_;
    std::vector<float> nodes_;
};

} // namespace tetra
