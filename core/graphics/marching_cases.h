// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace tetra {

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

} // namespace tetra
