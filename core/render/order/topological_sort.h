// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/face_adjacency.h"

#include <tan/base.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

/// A cell that must be drawn before another, though no face is between them: in the samples of a picture the one is
/// left and later the other entered, with a gap of the domain between.
struct CellRelation {
    std::uint32_t front;
    std::uint32_t back;
    auto operator<=>(const CellRelation&) const = default;
};

/// The two ends of a visibility order.
enum class OrderEnd { Front, Back };

/// The relations as they hold back cells that are taken from one end of the order: from the front a relation's front
/// holds its back, from the back it is the other way around. O(cells + relations); nothing if there are no relations.
class RelationTable {
public:
    /// May throw std::bad_alloc.
    RelationTable(std::span<const CellRelation> relations, std::size_t cells, OrderEnd end);

    bool isEmpty() const noexcept { return held_.empty(); }
    /// The cells that a cell holds back.
    std::span<const std::uint32_t> heldBy(std::uint32_t cell) const
    {
        return std::span(held_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
    }
    /// One of the relations that hold a cell back ends. Whether that was the last one.
    bool release(std::uint32_t cell) { return --left_[cell] == 0; }
    bool isHeld(std::uint32_t cell) const { return left_[cell] > 0; }

private:
    std::vector<std::uint32_t> held_;
    std::vector<std::uint32_t> first_; ///< for each cell, and after the last the end, in held_
    std::vector<std::uint32_t> left_;  ///< for each cell, how many relations hold it back
};

/// What hides what, from an eye. Refers to what it is made of.
struct OcclusionGraph {
    const FaceAdjacency& adjacency;
    std::span<const std::uint8_t> facing; ///< classifyFaces() of the cells
    std::span<const CellRelation> relations;

    std::size_t cellCount() const noexcept { return facing.size(); }
};

/// Takes cells one after the other, beginning at one end of the order: from the front a cell is free when all that hide
/// it are taken, from the back when all that it hides are. What became free first is taken first, so that from both
/// ends together there is little that is taken twice. Cells that hide each other in a circle, and what they hold back,
/// never become free. Two takings of one graph share nothing that changes: they may run at the same time. Keeps the
/// adjacency, but does not keep it alive; five bytes a cell, and what relations need.
class TopologicalSort {
public:
    /// O(cells + relations). May throw std::bad_alloc.
    TopologicalSort(const OcclusionGraph& graph, OrderEnd end);

    /// Takes cells until there are `most` of them in all, or until none is free. O(cells taken).
    void take(std::size_t most);
    /// Puts cells that are neither taken nor left yet behind all that will be taken, the last one first, for good: they
    /// hold back for ever what they hold back. For what was taken from the other end. May throw std::bad_alloc.
    void leave(std::span<const std::uint32_t> cells);
    /// From now on takes no other cells than these. There is no order() then. May throw std::bad_alloc.
    void restrictTo(std::span<const std::uint32_t> cells);

    /// The cells that are neither taken nor left, and not free. May throw std::bad_alloc.
    std::vector<std::uint32_t> held() const;
    bool isHeld(std::uint32_t cell) const { return isHeldBack(states_[cell]); }
    std::span<const std::uint32_t> taken() const { return std::span(cells_).first(taken_); }
    /// What was left, front to back if this takes from the front.
    std::span<const std::uint32_t> left() const { return std::span(cells_).subspan(end_); }
    /// Whether all cells are taken or left.
    bool isComplete() const noexcept { return taken_ == end_; }
    /// If it is complete: what was taken, then what was left.
    Buffer<std::uint32_t> order() && { return std::move(cells_); }

private:
    /// Bit f: this cell holds back its neighbour across face f; from bit 4 on: how many neighbours that hold it back
    /// are not taken yet, one more if relations hold it. At most five, and counted down no more than that: where
    /// inverted cells do not agree on a face it may go on below 0, wraps around and does not come to 0 again.
    using CellState = std::uint8_t;
    static constexpr unsigned facesOfState = 15;
    static constexpr unsigned oneHolder = 16;
    static constexpr unsigned beyondHeld = 6 * oneHolder;
    static constexpr unsigned never = 15 * oneHolder;
    static constexpr bool isHeldBack(unsigned state) { return state >= oneHolder && state < beyondHeld; }

    void release(std::span<std::uint32_t> cells);
    void releaseHeldBy(std::span<const std::uint32_t> batch);

    const FaceAdjacency* adjacency_;
    RelationTable relations_;
    Buffer<CellState> states_;
    Buffer<std::uint32_t> cells_; ///< what is taken, what is free, a gap, what is left
    std::size_t taken_ = 0;       ///< where in `cells_` that begins what is free
    std::size_t free_ = 0;        ///< where that ends
    std::size_t end_;             ///< where that begins what is left
};

/// When cycles hold back what is not taken: the cells among which they are to be looked for, which are neither before
/// all cycles nor behind them. What lies behind is left by `front`, in order. `front` and `back` have taken all that is
/// free at their ends, or at `back` half of the `cells`. `front` takes no more, and `back` is not needed any more. May
/// throw std::bad_alloc.
std::vector<std::uint32_t> heldByCycles(std::size_t cells, TopologicalSort& front, TopologicalSort& back);

} // namespace tetra
