// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/irregular/verify_boundary.h"
#include "core/model/mesh_claims.h"
#include "core/model/verify_parts.h"

#include <functional>

namespace tetra {

/// A mesh of irregular data and what it claims.
struct IrregularMesh {
    const Model& model;
    const IrregularOriginal& original;
    const Weights& weights;
    const LevelCells& cells;
    const MeshBoundary& boundary;
    const MeshClaims& claims;
};

/// The error at every point of the original and the warping at every vertex of its boundary (R4, R5), and, of cells of
/// a history, that the points count for a cell that grants both (FORMAT.md). A point in a cell has the error that it
/// has there, one outside that of the place of the boundary next to it or, if that is more than is claimed, of any one
/// within the claimed warping. Appends to `verdict`. An Error only if cancelled.
Status verifyRelated(const IrregularMesh& mesh, LevelVerdict& verdict, const Progress& progress);

} // namespace tetra
