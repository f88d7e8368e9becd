// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/face_adjacency.h"

#include "core/base/flat_index.h"
#include "core/mesh/topology.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

namespace tetra {

FaceMatching::FaceMatching(std::uint64_t sides)
{
    constexpr std::uint64_t fewFaces = 1000;
    most_ = sides / 2 + fewFaces;
    const std::uint64_t capacity = std::bit_ceil(most_ + most_ / 3);
    mask_ = capacity - 1;
    shift_ = static_cast<std::uint32_t>(64 - std::countr_zero(capacity));
    entries_.assign(capacity, Entry());
}

namespace {

/// A face whose other side is not known yet.
struct OpenFace {
    std::uint64_t lower; ///< its smallest corner, times 2^32, plus the middle one
    std::uint32_t largest;
    std::uint32_t name; ///< cell * 4 + face

    bool sameCorners(const OpenFace& other) const noexcept
    {
        return ((lower ^ other.lower) | (largest ^ other.largest)) == 0;
    }
    std::uint64_t hash() const noexcept
    {
        const std::uint64_t mixed = (lower ^ std::rotl(std::uint64_t(largest), 20)) * 0x9e3779b97f4a7c15u;
        return (mixed ^ mixed >> 29) * 0xbf58476d1ce4e5b9u;
    }
};

constexpr OpenFace noFace{~std::uint64_t(0), FaceAdjacency::none, FaceAdjacency::none};

/// The faces of a cell, its corners sorted without branches.
std::array<OpenFace, 4> facesOf(const Tetrahedron& cell, std::uint32_t index) noexcept
{
    std::uint64_t corners[4];
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] = std::uint64_t(cell[i]) << 2 | i;
    const auto order = [&](std::size_t a, std::size_t b) {
        const std::uint64_t smaller = std::min(corners[a], corners[b]);
        corners[b] = std::max(corners[a], corners[b]);
        corners[a] = smaller;
    };
    order(0, 1);
    order(2, 3);
    order(0, 2);
    order(1, 3);
    order(1, 2);
    const auto face = [&](std::size_t without, std::size_t a, std::size_t b, std::size_t c) {
        return OpenFace{(corners[a] >> 2) << 32 | corners[b] >> 2, static_cast<std::uint32_t>(corners[c] >> 2),
                        static_cast<std::uint32_t>(index * 4 + (corners[without] & 3))};
    };
    return {face(0, 1, 2, 3), face(1, 0, 2, 3), face(2, 0, 1, 3), face(3, 0, 1, 2)};
}

/// Matches the faces of a block of cells with one another through a small table, in which a face gives way to the next
/// one with the same place; returns what is left. Not a FlatIndex: the table forgets, so that it stays in the nearest
/// cache however many faces pass, and a place is looked at once, without a search.
class BlockMatcher {
public:
    static constexpr std::size_t blockSize = std::size_t(1) << 16;

    explicit BlockMatcher(Buffer<std::array<std::uint32_t, 4>>& neighbours)
        : neighbours_(neighbours), table_(tableSize), left_(4 * blockSize)
    {
    }

    Buffer<OpenFace> match(std::span<const Tetrahedron> cells, std::size_t first, std::size_t end)
    {
        std::ranges::fill(table_, noFace);
        std::size_t left = 0;
        for (std::size_t cell = first; cell < end; ++cell)
            for (const OpenFace& face : facesOf(cells[cell], static_cast<std::uint32_t>(cell)))
                left += take(face, left);
        for (const OpenFace& face : table_)
            if (face.name != FaceAdjacency::none)
                left_[left++] = face;
        return {left_.begin(), left_.begin() + static_cast<std::ptrdiff_t>(left)};
    }

private:
    static constexpr int tableBits = 13;
    static constexpr std::size_t tableSize = std::size_t(1) << tableBits;

    /// Whether one more is left. Without branches: half of all faces match.
    std::size_t take(const OpenFace& face, std::size_t left)
    {
        OpenFace& place = table_[face.hash() >> (64 - tableBits)];
        const OpenFace other = place;
        const bool same = face.sameCorners(other);
        left_[left] = other;
        place = same ? noFace : face;
        std::uint32_t nowhere = 0;
        std::uint32_t& back = same ? sideOf(other.name) : nowhere;
        back = face.name;
        sideOf(face.name) = same ? other.name : FaceAdjacency::none;
        return (same ? 0u : 1u) & (other.name != FaceAdjacency::none ? 1u : 0u);
    }

    std::uint32_t& sideOf(std::uint32_t name) { return neighbours_.data()[name >> 2][name & 3]; }

    Buffer<std::array<std::uint32_t, 4>>& neighbours_;
    Buffer<OpenFace> table_;
    Buffer<OpenFace> left_;
};

/// What the blocks left, dealt to parts by the corners.
class BinnedFaces {
public:
    explicit BinnedFaces(std::vector<Buffer<OpenFace>> blocks)
    {
        std::size_t count = 0;
        for (const auto& block : blocks)
            count += block.size();
        constexpr std::size_t facesInPart = 8192;
        partBits_ = std::min(static_cast<int>(std::bit_width(count / facesInPart)), mostPartBits);
        std::vector<std::vector<std::size_t>> places(blocks.size());
        tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t b) {
            places[b].assign(partCount(), 0);
            for (const OpenFace& face : blocks[b])
                ++places[b][partOf(face)];
        });
        std::size_t place = 0;
        for (std::size_t part = 0; part < partCount(); ++part) {
            first_.push_back(place);
            for (auto& block : places)
                place += std::exchange(block[part], place);
        }
        first_.push_back(place);
        faces_.resize(count);
        tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t b) {
            for (const OpenFace& face : blocks[b])
                faces_[places[b][partOf(face)]++] = face;
            blocks[b] = {};
        });
    }

    void match(Buffer<std::array<std::uint32_t, 4>>& neighbours) const
    {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, partCount()), [&](const auto& range) {
            FaceIndex index;
            for (std::size_t part = range.begin(); part != range.end(); ++part)
                matchPart(std::span(faces_).subspan(first_[part], first_[part + 1] - first_[part]), index, neighbours);
        });
    }

private:
    static constexpr int mostPartBits = 11;

    std::size_t partCount() const { return std::size_t(1) << partBits_; }
    std::size_t partOf(const OpenFace& face) const { return face.hash() & (partCount() - 1); }

    struct Hash {
        std::uint64_t operator()(const OpenFace& face) const noexcept { return face.hash(); }
    };
    struct SameCorners {
        bool operator()(const OpenFace& one, const OpenFace& other) const noexcept { return one.sameCorners(other); }
    };
    using FaceIndex = FlatIndex<OpenFace, Hash, SameCorners>; ///< the keys are the first sides

    static void matchPart(std::span<const OpenFace> faces, FaceIndex& index,
                          Buffer<std::array<std::uint32_t, 4>>& neighbours)
    {
        const auto sideOf = [&](std::uint32_t name) -> std::uint32_t& { return neighbours[name >> 2][name & 3]; };
        index.clear(faces.size());
        for (const OpenFace& face : faces) {
            const std::uint32_t other = index.firstLike(face).name;
            if (other == face.name || sideOf(other) != FaceAdjacency::none) // the first side, or a third one
                continue;
            sideOf(face.name) = other;
            sideOf(other) = face.name;
        }
    }

    int partBits_ = 0;
    std::vector<std::size_t> first_; ///< of each part's faces, and the end
    Buffer<OpenFace> faces_;
};

Buffer<std::uint8_t> innerFacesOf(const Buffer<std::array<std::uint32_t, 4>>& neighbours)
{
    Buffer<std::uint8_t> inner(neighbours.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, inner.size(), 1 << 14), [&](const auto& range) {
        for (std::size_t cell = range.begin(); cell != range.end(); ++cell) {
            unsigned bits = 0;
            for (unsigned face = 0; face < 4; ++face)
                bits |= (neighbours[cell][face] != FaceAdjacency::none ? 1u : 0u) << face;
            inner[cell] = static_cast<std::uint8_t>(bits);
        }
    });
    return inner;
}

} // namespace

FaceAdjacency matchFaces(std::span<const Tetrahedron> tetrahedra)
{
    constexpr std::size_t blockSize = BlockMatcher::blockSize;
    FaceAdjacency adjacency;
    adjacency.neighbours.resize(tetrahedra.size());
    std::vector<Buffer<OpenFace>> left((tetrahedra.size() + blockSize - 1) / blockSize);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, left.size()), [&](const auto& range) {
        BlockMatcher matcher(adjacency.neighbours);
        for (std::size_t b = range.begin(); b != range.end(); ++b)
            left[b] = matcher.match(tetrahedra, b * blockSize, std::min((b + 1) * blockSize, tetrahedra.size()));
    });
    BinnedFaces(std::move(left)).match(adjacency.neighbours);
    adjacency.innerFaces = innerFacesOf(adjacency.neighbours);
    return adjacency;
}

} // namespace tetra
