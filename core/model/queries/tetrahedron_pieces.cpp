// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/tetrahedron_pieces.h"

#include <algorithm>
#include <utility>

namespace tetra {

namespace {

/// The ways to turn a prism, by which each of its vertices can be made the first.
constexpr std::array<std::array<int, 6>, 6> turns = {{{0, 1, 2, 3, 4, 5},
                                                      {1, 2, 0, 4, 5, 3},
                                                      {2, 0, 1, 5, 3, 4},
                                                      {3, 5, 4, 0, 2, 1},
                                                      {4, 3, 5, 1, 0, 2},
                                                      {5, 4, 3, 2, 1, 0}}};

} // namespace

TetrahedronPieces splitPrism(const std::array<std::uint32_t, 6>& prism)
{
    // From the vertex of least number go the diagonals of both quadrilaterals that have it; the third is free.
    const auto& turn = turns[static_cast<std::size_t>(std::ranges::min_element(prism) - prism.begin())];
    std::array<std::uint32_t, 6> p{};
    std::ranges::transform(turn, p.begin(), [&prism](int place) { return prism[static_cast<std::size_t>(place)]; });
    TetrahedronPieces pieces;
    if (std::min(p[1], p[5]) < std::min(p[2], p[4])) {
        pieces.add(p[0], p[1], p[2], p[5]);
        pieces.add(p[0], p[1], p[5], p[4]);
    } else {
        pieces.add(p[0], p[1], p[2], p[4]);
        pieces.add(p[0], p[4], p[2], p[5]);
    }
    pieces.add(p[0], p[4], p[5], p[3]);
    return pieces;
}

TetrahedronPieces splitPyramid(const std::array<std::uint32_t, 4>& base, std::uint32_t top)
{
    const auto [a, b, c, d] = base;
    TetrahedronPieces pieces;
    if (std::min(a, c) < std::min(b, d)) {
        pieces.add(a, b, top, c);
        pieces.add(a, c, top, d);
    } else {
        pieces.add(a, b, top, d);
        pieces.add(d, b, top, c);
    }
    return pieces;
}

void orderBySides(std::array<std::uint32_t, 4>& tetrahedron, std::array<int, 4>& sides)
{
    bool odd = false;
    const auto swap = [&](std::size_t i) {
        std::swap(sides[i], sides[i + 1]);
        std::swap(tetrahedron[i], tetrahedron[i + 1]);
        odd = !odd;
    };
    for (std::size_t end = 3; end > 0; --end)
        for (std::size_t i = 0; i < end; ++i)
            if (sides[i] < sides[i + 1])
                swap(i);
    if (odd)
        swap(sides[1] > 0 ? 0 : 2); // among equals, or where the order does not matter
}

} // namespace tetra
