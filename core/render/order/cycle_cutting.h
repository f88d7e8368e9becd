// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/order/face_classification.h"
#include "core/render/order/topological_sort.h"

#include <tan/base.h>
#include <tan/mesh.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Pieces of cells that have no order as a whole: tetrahedra with the field of the cells that they are cut from.
struct CellPieces {
    std::vector<Eigen::Vector3d> positions;               ///< numbered after the vertices of the mesh
    std::vector<float> values;                            ///< there
    std::vector<std::array<std::uint32_t, 4>> tetrahedra; ///< numbered after the tetrahedra of the mesh
    std::vector<std::uint32_t> cells;                     ///< that each is a piece of
    std::size_t cutCells = 0;                             ///< how many those are
};

/// Cells front to back. Any array of cell numbers will do for drawing, from wherever it comes (S14).
struct VisibilityOrder {
    Buffer<std::uint32_t> cells; ///< numbers of cells and, for those that had to be cut, of their pieces
    CellPieces pieces;
    /// Groups of cells each of which hides all others of its group, directly or by way of others (C13).
    std::size_t cycles = 0;
    /// How often cells could not be told apart by a plane, because they overlap: the nearest by its centre comes first.
    std::size_t brokenCycles = 0;
};

/// Adds to `order` the cells `held`, which cycles hold back, front to back. What is in a cycle is cut: by the plane of
/// one of the faces, all on the eye's side of which comes before all behind it; those of either side that still make a
/// cycle are cut again (as in H. Fuchs, Z. Kedem, B. Naylor, "On visible surface generation by a priori tree
/// structures", SIGGRAPH 1980, but only as far as it is needed). So the order is right for every ray, whichever samples
/// made the relations. Each cut parts two neighbours, or cells that are apart, so it ends; overlapping cells, as
/// inverted ones make them, need not be parted by any plane and are counted. O(held + faces tried x cells of a cycle)
/// for each cut; of a large cycle only some of its faces are tried. May throw std::bad_alloc.
void orderCycles(const TetrahedralMesh& mesh, const OcclusionGraph& graph, const EyePoint& eye,
                 std::span<const std::uint32_t> held, VisibilityOrder& order);

} // namespace tetra
