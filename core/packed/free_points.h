// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetra {

/// The points of a dataset that are no sites yet, in the order of their numbers.
class FreePoints {
public:
    /// All of them.
    explicit FreePoints(std::uint64_t count) : words_((count + 63) / 64, ~std::uint64_t(0)), size_(count), free_(count)
    {
        if (count % 64 != 0)
            words_.back() >>= 64 - count % 64;
    }

    std::uint64_t count() const noexcept { return free_; }
    bool has(std::uint64_t point) const noexcept { return (words_[point / 64] >> point % 64 & 1) != 0; }
    /// One that is there.
    void remove(std::uint64_t point) noexcept
    {
        words_[point / 64] &= ~(std::uint64_t(1) << point % 64);
        --free_;
    }

    /// How many lie in [from, to).
    std::uint64_t countBetween(std::uint64_t from, std::uint64_t to) const noexcept
    {
        if (from >= to)
            return 0;
        const std::uint64_t first = from / 64, last = (to - 1) / 64;
        const std::uint64_t below = ~std::uint64_t(0) << from % 64, above = ~std::uint64_t(0) >> (63 - (to - 1) % 64);
        if (first == last)
            return countIn(words_[first] & below & above);
        std::uint64_t sum = countIn(words_[first] & below) + countIn(words_[last] & above);
        for (std::uint64_t word = first + 1; word < last; ++word)
            sum += countIn(words_[word]);
        return sum;
    }

    /// The one that has `skipped` others before it from `from` on, or size().
    std::uint64_t next(std::uint64_t from, std::uint64_t skipped) const noexcept
    {
        if (from >= size_)
            return size_;
        std::uint64_t number = from / 64;
        std::uint64_t word = words_[number] & ~std::uint64_t(0) << from % 64;
        for (;;) {
            const std::uint64_t there = countIn(word);
            if (skipped < there)
                break;
            skipped -= there;
            if (++number == words_.size())
                return size_;
            word = words_[number];
        }
        for (; skipped > 0; --skipped)
            word &= word - 1;
        return number * 64 + static_cast<std::uint64_t>(std::countr_zero(word));
    }

    /// Of the whole dataset.
    std::uint64_t size() const noexcept { return size_; }

private:
    static std::uint64_t countIn(std::uint64_t word) noexcept
    {
        return static_cast<std::uint64_t>(std::popcount(word));
    }

    std::vector<std::uint64_t> words_;
    std::uint64_t size_;
    std::uint64_t free_;
};

} // namespace tetra
