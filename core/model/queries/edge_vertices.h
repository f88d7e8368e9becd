// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace tetra {

/// The vertex on each of many edges: a table with open addressing, 12 to 48 bytes an edge.
class EdgeVertices {
public:
    /// The vertex on the edge from `smaller` to `larger`, which is set to `otherwise` if there is none yet.
    std::uint32_t on(std::uint32_t smaller, std::uint32_t larger, std::uint32_t otherwise)
    {
        if (2 * (count_ + 1) > entries_.size())
            grow();
        Entry& entry = entryOf(std::uint64_t(smaller) << 32 | larger);
        if (entry.edge == none) {
            entry = {std::uint64_t(smaller) << 32 | larger, otherwise};
            ++count_;
        }
        return entry.vertex;
    }

private:
    static constexpr std::uint64_t none = 0; ///< no edge goes from vertex 0 to itself
    struct Entry {
        std::uint64_t edge = none;
        std::uint32_t vertex = 0;
    };

    /// That of the edge, or the empty one where it belongs.
    Entry& entryOf(std::uint64_t edge)
    {
        const std::uint64_t mask = entries_.size() - 1;
        std::uint64_t place = (edge * 0x9e3779b97f4a7c15) >> 32;
        while (entries_[place & mask].edge != none && entries_[place & mask].edge != edge)
            ++place;
        return entries_[place & mask];
    }

    void grow()
    {
        std::vector<Entry> before(entries_.empty() ? 1024 : 2 * entries_.size());
        std::swap(before, entries_);
        for (const Entry& entry : before)
            if (entry.edge != none)
                entryOf(entry.edge) = entry;
    }

    std::vector<Entry> entries_;
    std::uint64_t count_ = 0;
};

} // namespace tetra
