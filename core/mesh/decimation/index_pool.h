// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Storage for many short lists of numbers. Blocks have sizes of powers of two and free lists by size; a larger free
/// block is halved when a small one is wanted.
class IndexPool {
public:
    struct List {
        std::uint32_t place = 0;
        std::uint32_t count = 0;
    };

    IndexPool() { freeBlocks_.fill(none); }

    std::span<std::uint32_t> operator[](List list) { return {storage_.data() + list.place, list.count}; }
    std::span<const std::uint32_t> operator[](List list) const { return {storage_.data() + list.place, list.count}; }

    /// Room for `count` numbers, whatever they are. May throw std::bad_alloc.
    List allocate(std::uint32_t count)
    {
        if (count == 0)
            return {};
        const std::uint32_t wanted = classOf(count);
        std::uint32_t from = wanted;
        while (from < classes && freeBlocks_[from] == none)
            ++from;
        if (from == classes) {
            const auto place = static_cast<std::uint32_t>(storage_.size());
            storage_.resize(storage_.size() + (std::size_t(1) << wanted));
            return {place, count};
        }
        const std::uint32_t place = freeBlocks_[from];
        freeBlocks_[from] = storage_[place];
        while (from > wanted) {
            --from;
            putBack(place + (1u << from), from);
        }
        return {place, count};
    }

    /// The list with more at its end; it may have moved. May throw std::bad_alloc.
    List appended(List list, std::span<const std::uint32_t> more)
    {
        const auto count = list.count + static_cast<std::uint32_t>(more.size());
        if (list.count > 0 && classOf(count) == classOf(list.count)) {
            std::ranges::copy(more, storage_.begin() + list.place + list.count);
            return {list.place, count};
        }
        const List longer = allocate(count);
        std::ranges::copy((*this)[list], (*this)[longer].begin());
        std::ranges::copy(more, (*this)[longer].begin() + list.count);
        release(list);
        return longer;
    }

    /// The list without a number that it has.
    List without(List list, std::uint32_t number)
    {
        const std::span<std::uint32_t> numbers = (*this)[list];
        *std::ranges::find(numbers, number) = numbers.back();
        --list.count;
        if (list.count == 0)
            putBack(list.place, 0);
        else if (classOf(list.count) != classOf(list.count + 1)) // the count says how large the block is
            putBack(list.place + (1u << classOf(list.count)), classOf(list.count));
        return list;
    }

    void release(List list)
    {
        if (list.count > 0)
            putBack(list.place, classOf(list.count));
    }

private:
    static constexpr std::uint32_t none = 0xffffffff;
    static constexpr std::uint32_t classes = 32;

    static std::uint32_t classOf(std::uint32_t count) { return static_cast<std::uint32_t>(std::bit_width(count - 1)); }
    void putBack(std::uint32_t place, std::uint32_t blockClass)
    {
        storage_[place] = freeBlocks_[blockClass];
        freeBlocks_[blockClass] = place;
    }

    std::vector<std::uint32_t> storage_;
    std::array<std::uint32_t, classes> freeBlocks_{};
};

} // namespace tetra
