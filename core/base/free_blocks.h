// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace tetra {

/// The free blocks of an array of 32-bit numbers, for pools of many short lists. Blocks have sizes of powers of two; a
/// larger one is halved when a small one is wanted, and halves are never joined again. A free block's first number is
/// the place of the next one of its size, so nothing is allocated. O(1).
class FreeBlocks {
public:
    static constexpr std::uint32_t none = 0xffffffff;

    FreeBlocks() { clear(); }
    void clear() { first_.fill(none); }

    /// The smallest n for which 2^n numbers are enough for `count`, which is not 0.
    static std::uint32_t classOf(std::uint32_t count) { return static_cast<std::uint32_t>(std::bit_width(count - 1)); }

    /// The place of a block of 2^sizeClass numbers in `storage`, no longer free; or none.
    std::uint32_t take(std::uint32_t* storage, std::uint32_t sizeClass)
    {
        std::uint32_t from = sizeClass;
        while (from < classes && first_[from] == none)
            ++from;
        if (from == classes)
            return none;
        const std::uint32_t place = first_[from];
        first_[from] = storage[place];
        while (from > sizeClass) {
            --from;
            putBack(storage, place + (1u << from), from);
        }
        return place;
    }
    void putBack(std::uint32_t* storage, std::uint32_t place, std::uint32_t sizeClass)
    {
        storage[place] = first_[sizeClass];
        first_[sizeClass] = place;
    }

private:
    static constexpr std::uint32_t classes = 32;

    std::array<std::uint32_t, classes> first_{}; ///< by size
};

} // namespace tetra
