// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tetra {

/// Which vertices are inside a surface: those whose value is at least its isovalue (S16). A byte each, four times
/// smaller than the values, so that more of them are in the cache.
class VertexSides {
public:
    /// O(values), on all threads. May throw std::bad_alloc.
    VertexSides(std::span<const float> values, double isovalue);

    std::size_t size() const noexcept { return bytes_.size() - padding; }
    /// 1 for each vertex inside, 0 for the others; after the last one come `padding` bytes more that may be read.
    const std::uint8_t* bytes() const noexcept { return bytes_.data(); }

private:
    static constexpr std::size_t padding = 3;

    Buffer<std::uint8_t> bytes_;
};

/// A tetrahedron that a surface crosses: where it is in its run, times 16, plus a bit for each corner inside.
using CrossedTetrahedron = std::uint32_t;

/// What findCrossed may write after the last one that it finds.
inline constexpr std::size_t crossedTetrahedronRoom = 16;

/// Finds the tetrahedra that have corners on both sides, in order; the first one is number `first` of its run. `found`
/// has room for all of them and crossedTetrahedronRoom more. Returns the end of what it found. O(tetrahedra).
CrossedTetrahedron* findCrossed(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::size_t first,
                                const VertexSides& sides, CrossedTetrahedron* found);

} // namespace tetra
