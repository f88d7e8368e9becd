// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
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

} // namespace tetra
