// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/cells/cell_complex.h"

#include <tan/data.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// How cells are cut into tetrahedra so that neighbours agree without knowing of each other: each quadrilateral gets
/// the diagonal through its smallest node, and a cell is what its smallest node sees (J. Dompierre, P. Labbe, M.-G.
/// Vallet, R. Camarero, "How to subdivide pyramids, prisms and hexahedra into tetrahedra", 1999; a pulling
/// triangulation). That never gets stuck: the diagonals of the smallest node's own faces all start there. Quadratic
/// cells: each corner is cut off through the middles of its edges, and what is left, a polytope whose corners are these
/// middles, is cut in the same way.

/// By numbers of points; corners may coincide (collapsed cells): pieces with a repeated corner are left out. Those of a
/// cell that is positive are positive: (b-a) . ((c-a) x (d-a)) > 0.
using CellPieces = std::vector<std::array<std::uint32_t, 4>>;
/// Triangles of a cell's surface, seen from outside a positive cell counterclockwise.
using CellSurface = std::vector<std::array<std::uint32_t, 3>>;

/// Four nodes of a face in their order around it, or three.
struct CellPolygon {
    std::array<std::uint32_t, 4> nodes{};
    std::uint32_t count = 0;
};

/// Whether the quadrilateral has the diagonal that its smallest node is *not* on.
using OtherDiagonal = std::function<bool(const CellPolygon& quadrilateral)>;

/// `nodes` are nodeCount(shape) numbers; voxels and triquadratic cells are made hexahedra before. Appends to `pieces`.
void splitCell(CellShape shape, std::span<const std::uint32_t> nodes, CellPieces& pieces);

/// The triangles in which the same cut ends on the surface, or those with some diagonals turned. Appends; a triangle
/// with a repeated corner is left out, and so are two that are each other's back.
void cellSurface(CellShape shape, std::span<const std::uint32_t> nodes, const OtherDiagonal& other,
                 CellSurface& surface);

/// The quadrilaterals among the faces of a linear cell.
std::vector<CellPolygon> quadrilateralsOf(CellShape shape, std::span<const std::uint32_t> nodes);

/// Tetrahedra of positive volume between the corners of a closed surface, without a new point, that end on exactly its
/// triangles (seen from outside counterclockwise); nothing if there are none, or if they were not found in
/// the trials that are left: `stepsLeft`, which this uses up, and 5000. A search that goes back where it gets stuck:
/// for the few corners of one cell. Whatever it finds fills what the surface encloses once, if the surface does not
/// meet itself: all pieces are positive and their inner faces cancel.
std::optional<CellPieces> fillCavity(std::span<const Eigen::Vector3d> positions, const CellSurface& surface,
                                     std::uint64_t& stepsLeft);

} // namespace tetra
