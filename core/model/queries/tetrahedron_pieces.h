// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace tetra {

/// Up to three tetrahedra that part of another one is made of.
struct TetrahedronPieces {
    int count = 0;
    std::array<std::array<std::uint32_t, 4>, 3> tetrahedra;

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) { tetrahedra[count++] = {a, b, c, d}; }
};

// Quadrilaterals are split by the diagonal from their vertex of least number: so neighbours do the same.

/// A prism with the bottom a, b, c and the top d, e, f, where (a, b, c, d) is positive, as positive tetrahedra.
TetrahedronPieces splitPrism(const std::array<std::uint32_t, 6>& prism);

/// A pyramid with the base a, b, c, d, in this order around it, where (a, b, top, c) is positive, likewise.
TetrahedronPieces splitPyramid(const std::array<std::uint32_t, 4>& base, std::uint32_t top);

/// Sorts the vertices so that their sides fall, but for those that are not positive if there is only one that is, which
/// come in any order. Orientation is kept.
void orderBySides(std::array<std::uint32_t, 4>& tetrahedron, std::array<int, 4>& sides);

} // namespace tetra
