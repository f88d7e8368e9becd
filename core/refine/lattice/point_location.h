// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/lattice/lattice_delaunay.h"
#include "core/refine/lattice/packed_lattice.h"

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

// Which tetrahedra of a lattice's mesh contain points. An insertion needs less: LatticeDelaunay::findConflict().

/// Goes for each point from the live tetrahedron slots[i], in a box that has the point, to one that contains the point,
/// always across the face that it is farthest beyond; in a Delaunay mesh that ends. Sets slots[i] to that, or to none
/// if it leads out of the mesh. Which of several it is depends on where it began and on nothing else. Exact; O(cube
/// root of the number of tetrahedra) from an arbitrary start. Several points at a time, since each step waits for
/// memory.
void locate(const LatticeDelaunay& delaunay, std::span<const PackedPoint> points, std::span<std::uint32_t> slots);

/// Where a point lies: a tetrahedron that contains it, and six times the volume of the point with the face opposite to
/// each of its vertices. None of these is negative; together they are the determinant.
struct PlacedPoint {
    std::uint32_t slot = LatticeDelaunay::none;
    std::array<std::int64_t, 4> volumes{};
};

/// Six times the volume of a point with the face opposite to each vertex of a positive tetrahedron: negative where the
/// point lies beyond the face.
std::array<std::int64_t, 4> volumesAt(const PackedLattice& lattice, PackedPoint point,
                                      const std::array<PackedPoint, 4>& vertices);

/// Where locate() finds a point from `slot`.
PlacedPoint placeIn(const LatticeDelaunay& delaunay, PackedPoint point, std::uint32_t slot);

/// As placeIn(), but across the first face that separates: of several tetrahedra that contain the point it may be
/// another one. Models of curvilinear grids in blocks depend on which it is, so that they keep this rule.
std::uint32_t walkByFirstFace(const LatticeDelaunay& delaunay, PackedPoint point, std::uint32_t slot);

} // namespace tetra
