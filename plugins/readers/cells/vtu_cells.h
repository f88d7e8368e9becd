// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/cells/vtu_head.h"

#include <tan/base.h>
#include <tan/data.h>

#include <cstdint>
#include <map>
#include <vector>

namespace tetra {

/// How cells were taken that a complex has no shape for, of all pieces.
struct VtuCellNotes {
    std::uint64_t wronglyLinear = 0;    ///< called linear, with the nodes of a quadratic cell
    std::uint64_t withoutFaceNodes = 0; ///< quadratic, with nodes in faces or the middle that were left out
    /// Lagrange cells of which the corners alone were taken, by their order; 0: not one order in all directions.
    std::map<std::uint64_t, std::uint64_t> byCorners{};
    bool joinsPoints = false; ///< there are lines or polygons, not vertices alone
};

/// The nodes of a piece's cells as the file has them: those of cell c end before nodes[ends[c]], numbers in the piece.
struct VtuNodes {
    std::vector<std::uint64_t> ends;
    std::vector<std::uint64_t> nodes;
};

/// Adds a piece's cells to a complex in which its points begin with the number `firstPoint`.
///
/// Lagrange cells of order 1 are the linear shapes; of order 2 the quadratic ones, as VTK numbers the nodes of both
/// alike (in hexahedra of files before version 2.1 it exchanges two of them), without the nodes in the faces of wedges.
/// Of higher ones, and of pyramids, whose nodes nobody numbers, the corners are taken. The order follows from the
/// number of nodes and, where there is an array HigherOrderDegrees, from that. Prisms of five and six sides are
/// polyhedra. Errors: numbers of points or faces that do not exist, too few nodes for a shape, shapes of other kinds,
/// by name.
Result<VtuNodes> addVtuCells(const VtuHead& head, const VtuPiece& piece, std::uint64_t firstPoint, CellComplex& complex,
                             VtuCellNotes& notes);

/// In sentences, for Dataset::remarks.
std::vector<Message> remarksOn(const VtuCellNotes& notes);

} // namespace tetra
