// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/topology.h"

#include <tan/base.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tetra {

/// Which vertices are inside a surface: those whose value is at least its isovalue (S16). A byte each, four times
/// smaller than the values, so that more of them are in the cache.
class VertexSigns {
public:
    /// O(values), on all threads. May throw std::bad_alloc.
    VertexSigns(std::span<const float> values, double isovalue);

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
                                const VertexSigns& sides, CrossedTetrahedron* found);

/// How an isosurface crosses a tetrahedron: the corners of a triangle (3) or of a quadrilateral (4) in order, each on
/// the edge between an inside and an outside corner of the tetrahedron. Seen from outside they run counterclockwise.
struct MarchingCase {
    int corners = 0;
    std::array<std::array<std::uint8_t, 2>, 4> edges{}; ///< the two corners of the tetrahedron
};

/// The case of a positive tetrahedron in which bit i of `inside` tells whether corner i is inside.
constexpr MarchingCase marchingCase(unsigned inside)
{
    using Index = std::uint8_t;
    // Each way to number the corners that keeps the tetrahedron positive and has a different first pair.
    constexpr std::array<std::array<Index, 4>, 12> even = {{{0, 1, 2, 3},
                                                            {0, 2, 3, 1},
                                                            {0, 3, 1, 2},
                                                            {1, 0, 3, 2},
                                                            {1, 2, 0, 3},
                                                            {1, 3, 2, 0},
                                                            {2, 0, 1, 3},
                                                            {2, 1, 3, 0},
                                                            {2, 3, 0, 1},
                                                            {3, 0, 2, 1},
                                                            {3, 1, 0, 2},
                                                            {3, 2, 1, 0}}};
    for (const auto& [i, j, k, l] : even) {
        if (inside == 1u << i)
            return {3, {{{i, j}, {i, k}, {i, l}}}};
        if ((inside ^ 15u) == 1u << i)
            return {3, {{{i, j}, {i, l}, {i, k}}}};
        if (inside == (1u << i | 1u << j))
            return {4, {{{i, k}, {i, l}, {j, l}, {j, k}}}};
    }
    return {};
}

/// All sixteen cases, by the bits of the corners inside.
inline constexpr std::array<MarchingCase, 16> marchingCases = [] {
    std::array<MarchingCase, 16> cases;
    for (unsigned inside = 0; inside < cases.size(); ++inside)
        cases[inside] = marchingCase(inside);
    return cases;
}();

/// Writes the edges that the corners of each tetrahedron's piece of the surface lie on, three or four in the order of
/// its marching case; `crossed` are some of `tetrahedra`. `edges` has room for four of each. Returns the end of what
/// counts. O(crossed).
EdgeKey* writeCrossedEdges(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                           std::span<const CrossedTetrahedron> crossed, EdgeKey* edges);

} // namespace tetra
