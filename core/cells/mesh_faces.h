// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// How the faces of positive tetrahedra lie against each other.
struct MeshFaces {
    static constexpr std::uint32_t none = 0xffffffff;
    std::vector<std::uint32_t> partners; ///< of side 4 t + f, the face of t opposite its corner f: the side against it
    std::vector<std::uint32_t> boundary; ///< the sides without one
    std::vector<std::uint32_t> crowded;  ///< tetrahedra at a face that three or more share, sorted
    std::vector<std::uint32_t> folded;   ///< tetrahedra on the same side of a face as its other one, sorted
};

/// Expected O(tetrahedra); up to 260 bytes each while it works. At most largestAdjacentCellCount of them.
MeshFaces findMeshFaces(std::span<const std::array<std::uint32_t, 4>> tetrahedra);

/// The corners of a side, seen from outside its tetrahedron counterclockwise.
std::array<std::uint32_t, 3> sideCorners(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::uint32_t side);

} // namespace tetra
