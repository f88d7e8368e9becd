// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <type_traits>

namespace tetra {

/// Spreads integers over 64 bits, the upper ones best: Fibonacci hashing.
struct FibonacciHash {
    std::uint64_t operator()(std::uint64_t key) const noexcept { return key * 0x9e3779b97f4a7c15u; }
};

/// Numbers keys by their first appearance: the first key is 0, the next one that differs is 1, and so on. What belongs
/// to a key lies in an array of the caller's, under its number.
///
///     FlatIndex<std::uint64_t> edges;
///     std::vector<Eigen::Vector3f> middles; // of each edge
///     for (...) {
///         const std::uint32_t number = edges.numberOf(edgeKey(a, b));
///         if (number == middles.size()) // the edge is new
///             middles.push_back((positions[a] + positions[b]) / 2);
///     }
///
/// A hash table with open addressing: slots with the numbers of keys, at most half of the slots in use, and the keys in
/// order. Unlike std::unordered_map it makes no allocation for each key and follows no pointers, the numbers do not
/// depend on the library, and the keys can be walked in their order. Whether a key is new is usually hard to predict,
/// so no branch depends on it. Keys cannot be removed one by one.
///
/// Keys are copied byte by byte, and every key equals itself; at most 2^32 - 2 differ. `Hash` gives 64 bits, the upper
/// ones well spread. Hash and equality may have data: keys that are indices into an array can be compared by what lies
/// there. Takes 8 to 16 bytes a key, and the key once or twice. All members are O(1) a key, growing included. May throw
/// std::bad_alloc.
template <class Key, class Hash = FibonacciHash, class Equal = std::equal_to<Key>> class FlatIndex {
    static_assert(std::is_trivially_copyable_v<Key>);

public:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    explicit FlatIndex(Hash hash = {}, Equal equal = {}) : hash_(hash), equal_(equal) {}

    /// Forgets all keys, but keeps their memory for the next ones. Makes slots for `expected` different keys. If more
    /// come, the slots grow and all keys are dealt to them anew; if fewer do, keys collide less often. O(expected).
    void clear(std::size_t expected = 0)
    {
        count_ = 0;
        makeSlots(slotsFor(expected + 1));
    }

    /// The key's number; a new key gets the next one. `key` is not one of keys(), which may move.
    std::uint32_t numberOf(const Key& key)
    {
        reserve(1);
        Numbering numbering = begin();
        const std::uint32_t number = numbering.numberOf(key);
        count_ = numbering.count;
        return number;
    }

    /// The first key that equals this one, itself if it is new. Valid until another one comes.
    const Key& firstLike(const Key& key) { return keys_[numberOf(key)]; }

    /// Calls take(i, number) with the number of each keys[i], in order: quicker than one by one. Makes slots for all of
    /// them. `take` does not use this index, and does not throw.
    template <class Take> void numberAll(std::span<const Key> keys, Take&& take)
    {
        reserve(keys.size());
        Numbering numbering = begin();
        for (std::size_t i = 0; i < keys.size(); ++i)
            take(i, numbering.numberOf(keys[i]));
        count_ = numbering.count;
    }

    /// The key's number, or none.
    std::uint32_t find(const Key& key) const noexcept
    {
        if (count_ == 0)
            return none;
        std::size_t slot = hash_(key) >> shift_;
        while (slots_[slot] != none && !equal_(keys_[slots_[slot]], key))
            slot = (slot + 1) & (slots_.size() - 1);
        return slots_[slot];
    }
    bool contains(const Key& key) const noexcept { return find(key) != none; }

    /// The different keys, each under its number. Valid until another one comes.
    std::span<const Key> keys() const noexcept { return {keys_.data(), count_}; }
    std::size_t size() const noexcept { return count_; }

private:
    static constexpr std::size_t smallestTable = 16;

    /// The state of numbering, small enough to be kept in registers.
    struct Numbering {
        std::uint32_t* table;
        Key* keys;
        std::size_t mask;
        int shift;
        std::uint32_t count;
        [[no_unique_address]] Hash hash;
        [[no_unique_address]] Equal equal;

        /// The key is put at the end first, as if it were new, with the next number: then an empty slot, whose `none`
        /// is larger than all numbers, reads as that number, and the search ends there, too.
        /// Key and slot are copied first: through references, the search would take a branch and more loads.
        std::uint32_t numberOf(const Key key)
        {
            keys[count] = key;
            for (std::size_t slot = hash(key) >> shift;; slot = (slot + 1) & mask) {
                const std::uint32_t found = table[slot];
                const std::uint32_t number = std::min(found, count);
                table[slot] = number;
                if (equal(keys[number], key)) {
                    count += number == count ? 1 : 0;
                    return number;
                }
            }
        }
    };

    Numbering begin() noexcept
    {
        return {slots_.data(), keys_.data(), slots_.size() - 1, shift_, count_, hash_, equal_};
    }

    static std::size_t slotsFor(std::size_t keys) { return std::bit_ceil(std::max(smallestTable, 2 * keys)); }

    /// Makes room for so many more keys, and for the one that is put at the end first.
    void reserve(std::size_t more)
    {
        const std::size_t wanted = count_ + more + 1;
        if (keys_.size() < wanted)
            keys_.resize(std::max(wanted, 2 * keys_.size()));
        if (slots_.size() < 2 * wanted)
            makeSlots(slotsFor(wanted));
    }

    void makeSlots(std::size_t size)
    {
        slots_.assign(size, none);
        shift_ = 64 - std::countr_zero(size);
        for (std::uint32_t number = 0; number < count_; ++number) {
            std::size_t slot = hash_(keys_[number]) >> shift_;
            while (slots_[slot] != none)
                slot = (slot + 1) & (size - 1);
            slots_[slot] = number;
        }
    }

    Buffer<std::uint32_t> slots_; ///< the number of the key that lies there, or none
    Buffer<Key> keys_;            ///< as many as count_, and room
    std::uint32_t count_ = 0;
    int shift_ = 0; ///< hash >> shift_ is the slot where a key's search begins
    [[no_unique_address]] Hash hash_;
    [[no_unique_address]] Equal equal_;
};

} // namespace tetra
