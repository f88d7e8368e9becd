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
    static std::uint64_t hashOf(std::uint64_t key) noexcept
    {
        const std::uint64_t mixed = key * 0x9e3779b97f4a7c15u;
        return (mixed ^ mixed >> 32) * 0xd6e8feb86659fd93u;
    }

    void clear()
    {
        count_ = 0;
        makeSlots(smallestTable);
    }
    /// Makes room for so many more keys; numberOf() needs it.
    void reserve(std::size_t more)
    {
        const std::size_t most = count_ + more;
        if (keys_.size() < most)
            keys_.resize(std::max(most, 2 * keys_.size()));
        if (slots_.size() < 2 * most)
            makeSlots(std::bit_ceil(2 * most));
    }
    std::uint32_t numberOf(std::uint64_t key) noexcept
    {
        for (std::size_t slot = hashOf(key) >> shift_;; slot = (slot + 1) & (slots_.size() - 1)) {
            const std::uint32_t number = slots_[slot];
            if (number == empty) {
                slots_[slot] = count_;
                keys_[count_] = key;
                return count_++;
            }
            if (keys_[number] == key)
                return number;
        }
    }
    std::span<const std::uint64_t> keys() const noexcept { return {keys_.data(), count_}; }

private:
    static constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();
    static constexpr std::size_t smallestTable = 1 << 12;

    void makeSlots(std::size_t size)
    {
        slots_.assign(size, empty);
        shift_ = 64 - std::countr_zero(size);
        for (std::uint32_t number = 0; number < count_; ++number) {
            std::size_t slot = hashOf(keys_[number]) >> shift_;
            while (slots_[slot] != empty)
                slot = (slot + 1) & (size - 1);
            slots_[slot] = number;
        }
    }

    Buffer<std::uint64_t> keys_;
    Buffer<std::uint32_t> slots_;
    std::uint32_t count_ = 0;
    int shift_ = 64;
};

} // namespace tetra
