// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetra {

/// A set of a model's sites, a bit each.
class SiteSet {
public:
    /// The sites before `prefix`, of `sites` in all.
    SiteSet(std::uint32_t sites, std::uint32_t prefix) : words_(sites / bits + std::size_t(1)), count_(prefix)
    {
        std::fill_n(words_.begin(), prefix / bits, ~std::uint64_t(0));
        words_[prefix / bits] = (std::uint64_t(1) << prefix % bits) - 1;
    }

    bool contains(std::uint32_t site) const { return (words_[site / bits] >> site % bits & 1) != 0; }
    void insert(std::uint32_t site)
    {
        count_ += contains(site) ? 0 : 1;
        words_[site / bits] |= bit(site);
    }
    void erase(std::uint32_t site)
    {
        count_ -= contains(site) ? 1 : 0;
        words_[site / bits] &= ~bit(site);
    }
    std::uint32_t count() const noexcept { return count_; }

    /// Calls `visit(site)` for each, ascending, from `first` on.
    template <class Visit> void visitFrom(std::uint32_t first, const Visit& visit) const
    {
        for (std::size_t place = first / bits; place < words_.size(); ++place) {
            std::uint64_t word = words_[place];
            if (place == first / bits)
                word &= ~((std::uint64_t(1) << first % bits) - 1);
            for (; word != 0; word &= word - 1)
                visit(static_cast<std::uint32_t>(place * bits + static_cast<unsigned>(std::countr_zero(word))));
        }
    }

    bool operator==(const SiteSet&) const = default;

private:
    static constexpr std::uint32_t bits = 64;
    static std::uint64_t bit(std::uint32_t site) { return std::uint64_t(1) << site % bits; }

    std::vector<std::uint64_t> words_;
    std::uint32_t count_ = 0;
};

} // namespace tetra
