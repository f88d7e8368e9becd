// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>

namespace tetra {

/// Numbers 64-bit keys by their first appearance: a hash table by open addressing. Its memory is used again after
/// clear().
class EdgeTable {
public:
    /// What takes keys, small enough to be kept in registers.
    struct Numbering {
        std::uint32_t* slots;
        std::uint64_t* keys;
        std::size_t mask;
        int shift;
        std::uint32_t count;

        /// Whether the key is new is hard to predict, so that decides no branch.
        std::uint32_t numberOf(std::uint64_t key) noexcept
        {
            keys[count] = key;
            for (std::size_t slot = placeOf(key, shift);; slot = (slot + 1) & mask) {
                const std::uint32_t known = slots[slot];
                const std::uint32_t number = std::min(known, count); // unknown is the largest number
                slots[slot] = number;
                if (keys[number] == key) {
                    count += number == count ? 1 : 0;
                    return number;
                }
            }
        }
    };

    /// Forgets all keys. About so many are to come: to grow later is slow.
    void clear(std::size_t expected)
    {
        count_ = 0;
        makeSlots(std::bit_ceil(std::max(smallestTable, roomForOne * expected)));
    }
    /// Makes room for so many more keys. Hand back with end() what took them.
    Numbering begin(std::size_t more)
    {
        const std::size_t most = count_ + more + 1;
        if (keys_.size() < most)
            keys_.resize(std::max(most, 2 * keys_.size()));
        if (slots_.size() < roomForOne * most)
            makeSlots(std::bit_ceil(roomForOne * most));
        return {slots_.data(), keys_.data(), slots_.size() - 1, 64 - std::countr_zero(slots_.size()), count_};
    }
    void end(const Numbering& numbering) { count_ = numbering.count; }
    std::span<const std::uint64_t> keys() const noexcept { return {keys_.data(), count_}; }

private:
    static constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();
    static constexpr std::size_t smallestTable = 1 << 12;
    static constexpr std::size_t roomForOne = 8;

    static std::size_t placeOf(std::uint64_t key, int shift) noexcept { return key * 0x9e3779b97f4a7c15u >> shift; }

    void makeSlots(std::size_t size)
    {
        slots_.assign(size, unknown);
        const int shift = 64 - std::countr_zero(size);
        for (std::uint32_t number = 0; number < count_; ++number) {
            std::size_t slot = placeOf(keys_[number], shift);
            while (slots_[slot] != unknown)
                slot = (slot + 1) & (size - 1);
            slots_[slot] = number;
        }
    }

    Buffer<std::uint64_t> keys_;
    Buffer<std::uint32_t> slots_;
    std::uint32_t count_ = 0;
};

} // namespace tetra
