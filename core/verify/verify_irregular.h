// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/verify/irregular_original.h"
#include "core/verify/mesh_bounds.h"
#include "core/verify/verify_boundary.h"
#include "core/verify/verify_parts.h"

#include <functional>
#include <string>
#include <vector>

namespace tetra {

/// A mesh of irregular data and what it claims.
struct IrregularMesh {
    const Model& model;
    const IrregularOriginal& original;
    const Weights& weights;
    const LevelCells& cells;
    const MeshBoundary& boundary;
    const MeshBounds& claims;
};

/// The error at every point of the original and the warping at every vertex of its boundary (R4, R5), and, of cells of
/// a history, that the points count for a cell that grants both (FORMAT.md). A point in a cell has the error that it
/// has there, one outside that of the place of the boundary next to it or, if that is more than is claimed, of any one
/// within the claimed warping. Appends to `verdict`. An Error only if cancelled.
Status verifyRelated(const IrregularMesh& mesh, LevelReport& verdict, const Progress& progress);

/// verifyPlacedHistory(), and that the first mesh is one of the data: as verifyIrregularCells(), but it claims nothing.
/// For a history whose indices can be followed. An Error only if cancelled.
Status verifyIrregularHistory(const Model& model, const IrregularOriginal& original,
                              const std::vector<LatticePoint>& places, const Weights& weights,
                              std::vector<std::string>& failures, const Progress& progress);

/// As verifyLevel(). Claimed errors are kept if they are exceeded by no more than 1e-12 of the value range.
Result<LevelReport> verifyIrregularLevel(const Model& model, const IrregularOriginal& original,
                                         const std::vector<LatticePoint>& places, const Weights& weights,
                                         const Accuracy& asked, const Progress& progress);

/// Cells of irregular data: they have volume, conform, and lie on one another nowhere; their boundary is a manifold
/// that does not meet itself, with the original's components, surfaces and Euler characteristics (S12); at every
/// original vertex they keep the error and the warping that is claimed (R4, R5, FORMAT.md). Says how far the boundary
/// goes from the original's (S13), which is judged only if the model's parameter `distance` claims it. Appends to
/// `verdict`.
Status verifyIrregularCells(const Model& model, const IrregularOriginal& original, const Weights& weights,
                            const LevelCells& cells, const MeshBounds& claims, LevelReport& verdict,
                            const Progress& progress);

} // namespace tetra
