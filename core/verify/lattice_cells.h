// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/verify/curvilinear_cells.h"
#include "core/verify/level_faces.h"
#include "core/verify/mesh_bounds.h"
#include "core/verify/verify_parts.h"

namespace tetra {

/// A mesh and what it claims.
struct MeshToVerify {
    const Model& model;
    const Dataset& original;
    const Weights& weights;
    const LevelCells& cells;
    const MeshBounds& claims;
    const CurvilinearOriginal* lifted = nullptr; ///< of curvilinear data
};

/// Cells of a regular lattice or of curvilinear data: they conform, fill the domain, have volume, and keep what is
/// claimed at every sample; cells of a history also their own errors. Appends to `verdict`.
Status verifyLatticeCells(const MeshToVerify& mesh, LevelReport& verdict, const Progress& progress);

/// What of cells of curvilinear data holds in physical space: inverted cells, and the warping at every sample (R4).
Status verifyCurvilinear(const MeshToVerify& mesh, LevelReport& verdict, const Progress& progress);

} // namespace tetra
