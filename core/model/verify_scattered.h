// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/level_cells.h"
#include "core/model/mesh_claims.h"
#include "core/model/point_tree.h"
#include "core/model/verify_parts.h"

#include <span>
#include <string>
#include <vector>

namespace tetra {

/// The original points of a model of scattered data, ready to be looked for.
struct ScatteredOriginal {
    explicit ScatteredOriginal(const Dataset& dataset);

    std::span<const Eigen::Vector3d> positions;
    std::vector<double> values;
    double extent = 0; ///< of the values
    PointTree tree;

    double percent(double error) const { return extent > 0 ? 100 * error / extent : 0; }
};

/// That every site lies where its point lies, and every tetrahedron that ever lived is positive. For a history whose
/// indices can be followed. An Error only if cancelled.
Status verifyPlacedHistory(const Model& model, const ScatteredOriginal& original, std::vector<std::string>& failures,
                           const Progress& progress);
/// That cells are positive; appends to `verdict`.
void verifyPlacedVolumes(const ScatteredOriginal& original, const LevelCells& cells, LevelVerdict& verdict);

/// verifyPlacedHistory(), and that the first mesh fills the convex hull of all points: with that, a later mesh fills it
/// if its boundary faces have the first mesh's sites on one side only. For a history whose indices can be followed. An
/// Error only if cancelled.
Status verifyScatteredHistory(const Model& model, const ScatteredOriginal& original,
                              const std::vector<LatticePoint>& places, const Weights& weights,
                              std::vector<std::string>& failures, const Progress& progress);

/// As verifyLevel(). Claims are kept if they are exceeded by no more than 1e-12 of the value range: the interpolation
/// is computed with 113 bits where it is close.
Result<LevelVerdict> verifyScatteredLevel(const Model& model, const ScatteredOriginal& original,
                                          const std::vector<LatticePoint>& places, const Weights& weights,
                                          const Accuracy& asked, const Progress& progress);

/// Cells of scattered data: they conform, fill the domain, have volume, and keep what is claimed at every point. Takes
/// the first mesh to fill the domain, see verifyScatteredHistory(). Appends to `verdict`.
Status verifyScatteredCells(const Model& model, const ScatteredOriginal& original, const Weights& weights,
                            const LevelCells& cells, const MeshClaims& claims, LevelVerdict& verdict,
                            const Progress& progress);

} // namespace tetra
