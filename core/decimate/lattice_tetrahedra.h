// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// How the cells of a lattice are cut into tetrahedra. Both cuts put the same diagonal on both sides of a face.
enum class LatticeCut {
    Five, ///< one in the middle and four around it, mirrored from cell to cell
    Six   ///< around the diagonal from the lowest to the highest corner, the same in all cells
};

/// The tetrahedra of a lattice of `size` points, x fastest, positive; nothing if it has no cell. At most 2^32 - 2
/// points. O(cells); may throw std::bad_alloc.
std::vector<std::array<std::uint32_t, 4>> latticeTetrahedra(const std::array<std::uint32_t, 3>& size, LatticeCut cut);

} // namespace tetra
