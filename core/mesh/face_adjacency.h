// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/mesh.h>

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// Finds the two sides of each face of a mesh: a hash table by keys that do not depend on the order of a face's
/// vertices. About 64 bytes a tetrahedron while it works. Not a FlatIndex: all that is known of a face lies in one line
/// of the cache, which can be fetched ahead.
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

/// Which face lies against which (R2). Faces are numbered as in topology.h.
struct FaceAdjacency {
    static constexpr std::uint32_t none = 0xffffffff; ///< on the boundary
    /// For each cell and each of its faces: cell * 4 + face of the face on the other side, or none.
    Buffer<std::array<std::uint32_t, 4>> neighbours;
    Buffer<std::uint8_t> innerFaces; ///< for each cell, bit f: face f has a cell on its other side

    static std::uint32_t cellOf(std::uint32_t neighbour) noexcept { return neighbour >> 2; }
    static std::uint32_t faceOf(std::uint32_t neighbour) noexcept { return neighbour & 3; }
};

/// The most cells that adjacency can number.
inline constexpr std::size_t largestAdjacentCellCount = std::size_t(1) << 30;

/// Matches the faces of tetrahedra whose corners exist. A face that more than two cells share, which no sound mesh
/// has, is matched in pairs, and what is left over is on the boundary. First among the cells just before, by a small
/// table; what is left, little if the mesh is in spatial order, is dealt to parts that fit the cache. O(cells), on all
/// threads of the current arena, the same result with any number of them; up to 100 bytes a cell while it runs, a fifth
/// of that in spatial order. May throw std::bad_alloc.
FaceAdjacency matchFaces(std::span<const std::array<std::uint32_t, 4>> tetrahedra);

} // namespace tetra
