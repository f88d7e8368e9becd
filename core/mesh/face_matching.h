// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"

#include <cstdint>

namespace tetra {

/// Finds the two sides of each face of a mesh: a hash table by keys that do not depend on the order of a face's
/// vertices. About 64 bytes a tetrahedron while it works.
class FaceMatching {
public:
    static constexpr std::uint32_t none = 0xffffffff;

    /// For so many sides of faces: two a face, but for a few. May throw std::bad_alloc.
    explicit FaceMatching(std::uint64_t sides);

    /// Sums of these over the three vertices are different for different faces, as good as always.
    static std::uint64_t keyOf(std::uint32_t vertex) noexcept
    {
        std::uint64_t key = (vertex + 1ull) * 0x9e3779b97f4a7c15;
        key ^= key >> 29;
        key *= 0xbf58476d1ce4e5b9;
        return key ^ key >> 32;
    }
    void prefetch(std::uint64_t key) const { __builtin_prefetch(&entries_[placeOf(key)], 1); }

    /// The side that was added with the same key before, or none. A third one, or more faces than a mesh of so many
    /// sides has, give `side` itself.
    std::uint32_t add(std::uint64_t key, std::uint32_t side)
    {
        for (std::uint64_t place = placeOf(key);; place = (place + 1) & mask_) {
            Entry& entry = entries_[place];
            if (entry.side == none) {
                if (used_ == most_)
                    return side;
                ++used_;
                entry = {key, side, false};
                ++single_;
                return none;
            }
            if (entry.key != key)
                continue;
            if (entry.paired)
                return side;
            entry.paired = true;
            --single_;
            return entry.side;
        }
    }
    /// Faces with one side so far.
    std::uint64_t singleCount() const noexcept { return single_; }

private:
    struct Entry {
        std::uint64_t key = 0;
        std::uint32_t side = none;
        bool paired = false;
    };
    std::uint64_t placeOf(std::uint64_t key) const noexcept { return key * 0x9e3779b97f4a7c15 >> shift_; }

    std::uint64_t mask_ = 0;
    std::uint32_t shift_ = 0;
    std::uint64_t most_ = 0;
    std::uint64_t used_ = 0;
    std::uint64_t single_ = 0;
    Buffer<Entry> entries_;
};

} // namespace tetra
