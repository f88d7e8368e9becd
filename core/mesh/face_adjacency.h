// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// Which face lies against which (R2). Faces are numbered as in topology.h.
struct FaceAdjacency {
    static constexpr std::uint32_t none = 0xffffffff; ///< on the boundary
    /// For each cell and each of its faces: cell * 4 + face of the face on the other side, or none.
    Buffer<std::array<std::uint32_t, 4>> neighbours;
    Buffer<std::uint8_t> innerFaces; ///< for each cell, bit f: face f has a cell on its other side

    static std::uint32_t cellOf(std::uint32_t neighbour) noexcept { return neighbour >> 2; }
    static std::uint32_t faceOf(std::uint32_t neighbour) noexcept { return neighbour & 3; }
};

/// The most cells that adjacency can number.
inline constexpr std::size_t largestAdjacentCellCount = std::size_t(1) << 30;

/// Matches the faces of tetrahedra whose corners exist. A face that more than two cells share, which no sound mesh
/// has, is matched in pairs, and what is left over is on the boundary. First among the cells just before, by a small
/// table; what is left, little if the mesh is in spatial order, is dealt to parts that fit the cache. O(cells), on all
/// threads of the current arena, the same result with any number of them; up to 100 bytes a cell while it runs, a fifth
/// of that in spatial order. May throw std::bad_alloc.
FaceAdjacency matchFaces(std::span<const std::array<std::uint32_t, 4>> tetrahedra);

} // namespace tetra
