// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tetra {

/// The largest of many numbers, none below 0, that change one at a time: a tree of maxima of sixteen, which share a
/// line of the cache.
class KeyTournament {
public:
    /// All are 0. May throw std::bad_alloc.
    explicit KeyTournament(std::size_t count)
    {
        do {
            count = (count + width - 1) / width;
            levels_.emplace_back(width * std::max<std::size_t>(count, 1));
        } while (count > 1);
    }

    /// O(log count) at worst, a step or two where the number is far from the largest.
    void set(std::size_t index, float key)
    {
        for (std::vector<float>& level : levels_) {
            const float before = level[index];
            level[index] = key;
            if (before == key)
                return;
            const float* const group = level.data() + index / width * width;
            float others = 0;
            for (std::size_t i = 0; i < width; ++i)
                others = std::max(others, i == index % width ? 0 : group[i]);
            if (others >= std::max(before, key))
                return;
            key = std::max(key, others);
            index /= width;
        }
        largest_ = key;
    }
    void prefetch(std::size_t index) const { __builtin_prefetch(&levels_.front()[index]); }
    float largest() const noexcept { return largest_; }

private:
    static constexpr std::size_t width = 16;

    std::vector<std::vector<float>> levels_; ///< the numbers first
    float largest_ = 0;
};

} // namespace tetra
