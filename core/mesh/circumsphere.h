// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/lattice_box.h"
#include "core/mesh/lattice_delaunay.h"

#include <optional>

namespace tetra {

/// Of the lattice points in `box` strictly inside the circumsphere of `tetrahedron`, the one nearest to its centre
/// (ties go to the first in the lattice), or none. Unit spacing. Exact, O(1). In a Delaunay mesh of the box no vertex
/// lies strictly inside, so what is found is not a vertex yet.
std::optional<PackedPoint> deepestPointInSphere(const PackedLattice& lattice, const DelaunayTetrahedron& tetrahedron,
                                                const LatticeBox& box);

} // namespace tetra
