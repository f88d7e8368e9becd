// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/packed_lattice.h"

#include <bit>
#include <cstdint>
#include <queue>
#include <vector>

namespace tetra {

/// The flipped tetrahedra that wait for a point, the one with the largest key first, ties by the first point of the
/// lattice (S5). A band of its own above the queue of errors, because a flipped tetrahedron waits even if its key is 0.
/// Entries of tetrahedra that have died are dropped when they are met.
class FlipQueue {
public:
    /// `history` is the tetrahedron's number in the history, by which it is known whether it still lives.
    void push(float key, PackedPoint point, std::uint32_t slot, std::uint32_t history)
    {
        entries_.push({std::uint64_t(std::bit_cast<std::uint32_t>(key)) << 32 | ~point, slot, history});
    }

    static constexpr std::uint32_t none = 0xffffffff;
    /// The slot of the foremost tetrahedron that `alive(slot, history)` says lives, or none. It stays in the queue.
    template <class Alive> std::uint32_t top(const Alive& alive)
    {
        while (!entries_.empty() && !alive(entries_.top().slot, entries_.top().history))
            entries_.pop();
        return entries_.empty() ? none : entries_.top().slot;
    }
    void pop() { entries_.pop(); }

private:
    struct Entry {
        std::uint64_t order;
        std::uint32_t slot;
        std::uint32_t history;
        bool operator<(const Entry& other) const { return order < other.order; }
    };
    std::priority_queue<Entry> entries_;
};

} // namespace tetra
