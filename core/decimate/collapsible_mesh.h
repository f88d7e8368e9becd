// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/free_blocks.h"
#include "core/base/saved_state.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Storage for many short lists of numbers.
class IndexPool {
public:
    struct List {
        std::uint32_t place = 0;
        std::uint32_t count = 0;
    };

    std::span<std::uint32_t> operator[](List list) { return {storage_.data() + list.place, list.count}; }
    std::span<const std::uint32_t> operator[](List list) const { return {storage_.data() + list.place, list.count}; }

    /// Room for `count` numbers, whatever they are. May throw std::bad_alloc.
    List allocate(std::uint32_t count)
    {
        if (count == 0)
            return {};
        const std::uint32_t wanted = classOf(count);
        if (const std::uint32_t place = freeBlocks_.take(storage_.data(), wanted); place != FreeBlocks::none)
            return {place, count};
        const auto place = static_cast<std::uint32_t>(storage_.size());
        storage_.resize(storage_.size() + (std::size_t(1) << wanted));
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

    void archive(StateArchive& archive) { archive(storage_, freeBlocks_); }

private:
    static std::uint32_t classOf(std::uint32_t count) { return FreeBlocks::classOf(count); }
    void putBack(std::uint32_t place, std::uint32_t sizeClass)
    {
        freeBlocks_.putBack(storage_.data(), place, sizeClass);
    }

    std::vector<std::uint32_t> storage_;
    FreeBlocks freeBlocks_;
};

/// What decimation keeps with a tetrahedron besides its geometry.
struct TetrahedronState {
    IndexPool::List inside;            ///< the removed points that it has
    float error = 0;                   ///< its own: of these and of the points outside that are related to it
    std::uint32_t madeBy = 0xffffffff; ///< the collapse that made it; CollapseLog::none if none did
};

/// Tetrahedra that half-edge collapses keep conforming, with those around each vertex. Each has a slot; what survives a
/// collapse stays in its slot, with another vertex. Looking at a star touches few places in memory, and all at once.
class CollapsibleMesh {
public:
    static constexpr std::uint32_t none = 0xffffffff;
    /// Numbers of boundary triangles begin here, numbers of slots end before.
    static constexpr std::uint32_t firstTriangle = 0x80000000;
    static constexpr bool isTriangle(std::uint32_t neighbour) noexcept { return neighbour >= firstTriangle; }

    using Four = std::array<std::uint32_t, 4>;

    /// `tetrahedra` conform, fewer than 2^30. `withNeighbours`: whether these and boundary triangles are wanted; to
    /// keep them takes a third of a collapse. May throw std::bad_alloc.
    CollapsibleMesh(std::uint32_t vertexCount, std::span<const Four> tetrahedra, bool withNeighbours);

    std::uint32_t slotCount() const noexcept { return static_cast<std::uint32_t>(tetrahedra_.size()); }
    bool alive(std::uint32_t slot) const noexcept { return vertices(slot)[0] != none; }
    /// Positive; the first is none where the slot is empty.
    const Four& vertices(std::uint32_t slot) const noexcept { return tetrahedra_[slot].vertices; }
    /// Only kept here: it shares a line of the cache with the vertices, and is nearly always wanted with them.
    TetrahedronState& state(std::uint32_t slot) noexcept { return tetrahedra_[slot].state; }
    const TetrahedronState& state(std::uint32_t slot) const noexcept { return tetrahedra_[slot].state; }
    void prefetch(std::uint32_t slot) const { __builtin_prefetch(&tetrahedra_[slot]); }
    void prefetchStar(std::uint32_t vertex) const { __builtin_prefetch(star(vertex).data()); }
    void prefetchStarsPlace(std::uint32_t vertex) const { __builtin_prefetch(&stars_[vertex]); }
    /// Slots or boundary triangles, each opposite to the vertex.
    const Four& neighbours(std::uint32_t slot) const noexcept { return neighbours_[slot]; }
    /// The tetrahedra around a vertex; none if it was removed.
    std::span<const std::uint32_t> star(std::uint32_t vertex) const noexcept { return pool_[stars_[vertex]]; }

    /// Boundary triangles that ever were: they keep their numbers when a vertex of theirs moves.
    std::uint32_t triangleCount() const noexcept { return static_cast<std::uint32_t>(slotOfTriangle_.size()); }
    /// The tetrahedron that has a boundary triangle now.
    std::uint32_t slotOfTriangle(std::uint32_t triangle) const noexcept
    {
        return slotOfTriangle_[triangle - firstTriangle];
    }
    /// The corners of a boundary triangle, counterclockwise from outside.
    std::array<std::uint32_t, 3> cornersOf(std::uint32_t triangle) const noexcept;

    /// The corners of the face opposite to a corner of a tetrahedron, counterclockwise from outside.
    std::array<std::uint32_t, 3> cornersOfFaceOf(std::uint32_t slot, std::size_t corner) const noexcept
    {
        const auto& [a, b, c] = cornersOfFace[corner];
        const Four& four = vertices(slot);
        return {four[a], four[b], four[c]};
    }

    /// Moves `vertex` onto its neighbour `target`: tetrahedra that hold both vanish. None may have both of its faces
    /// opposite to them on the boundary. May throw std::bad_alloc.
    void collapse(std::uint32_t vertex, std::uint32_t target);

    void archive(StateArchive& archive) { archive(tetrahedra_, neighbours_, stars_, pool_, slotOfTriangle_); }

private:
    struct alignas(32) Tetrahedron {
        Four vertices;
        TetrahedronState state;
    };

    void findNeighbours(std::span<const Four> tetrahedra);
    void setStars(std::uint32_t vertexCount);
    void remove(std::uint32_t slot, std::uint32_t vertex, std::uint32_t target);
    void replaceNeighbour(std::uint32_t slot, std::uint32_t before, std::uint32_t after);

    std::vector<Tetrahedron> tetrahedra_; ///< by slot
    std::vector<Four> neighbours_;
    std::vector<IndexPool::List> stars_; ///< by vertex
    IndexPool pool_;
    std::vector<std::uint32_t> slotOfTriangle_;
    std::vector<std::uint32_t> moved_;
};

/// Which of four different ones it is; 0 if none.
inline std::size_t indexOf(const std::array<std::uint32_t, 4>& four, std::uint32_t one) noexcept
{
    return std::size_t{four[1] == one} + 2 * std::size_t{four[2] == one} + 3 * std::size_t{four[3] == one};
}

} // namespace tetra
