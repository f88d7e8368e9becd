// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/lattice_delaunay.h"

namespace tetra {

/// The live tetrahedron that contains `point`, found by walking from `slot`, a live one in the same box, which must
/// contain the point: always across a face that separates the two. In a Delaunay mesh that ends. Exact; O(cube root of
/// the number of tetrahedra) from an arbitrary start.
std::uint32_t walkTo(const LatticeDelaunay& delaunay, PackedPoint point, std::uint32_t slot);

/// Whether `point` lies on the inner side of the face opposite to `vertices[0]`, or on it.
bool onInnerSide(const PackedLattice& lattice, PackedPoint point, const std::array<PackedPoint, 4>& vertices);

} // namespace tetra
