// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/dataset.h"
#include "core/history/model.h"
#include "core/verify/exact_cell.h"
#include "core/verify/verification.h"

#include <string>
#include <vector>

namespace tetra {

class CurvilinearOriginal;

/// The parts of verify(). Each appends to `failures` what it found, and gives an Error only if it was cancelled.

/// Checksums, padding, reserved fields: every byte of the file has the value that it was written with.
Status verifyBytes(const Model& model, std::vector<std::string>& failures, const Progress& progress);

/// The sites of the first mesh: the leading ones of infinite running error.
std::uint32_t initialSiteCount(const Model& model);

/// The sites of the first mesh whose error is at most `asked`, in units of the values, found by looking at one after
/// the other (S1).
std::uint32_t firstPassage(const Model& model, double asked);
/// The largest running key of a mesh that keeps both thresholds (S4), for values and points of this extent.
double keyAsked(const Model& model, double extent, double diagonal, const Accuracy& asked);
/// What the model claims of the mesh of its first sites.
double claimedKey(const Model& model, std::uint32_t sites);

/// That the model is one of this dataset: lattice, type, range, hash. False if not even the lattice or the type fit, so
/// that nothing can be compared.
bool verifySource(const Model& model, const Dataset& original, std::vector<std::string>& failures);

/// Where the sites lie, after checking that they are distinct points of the lattice, the corners among the
/// initial ones, with the samples of the original; and that the running errors do not increase. Empty if a site is no
/// point.
std::vector<LatticePoint> verifySites(const Model& model, const Dataset& original, std::vector<std::string>& failures);

/// The history as a whole: creators are the latest sites, destroyers come later, every tetrahedron that ever lived is
/// positive, every group fills exactly the volume that it empties, mesh sizes follow. Without `places`, nothing is said
/// of volumes. `usable` becomes false if
/// indices are so wrong that they cannot be followed.
Status verifyHistory(const Model& model, const std::vector<LatticePoint>& places, std::vector<std::string>& failures,
                     bool& usable, const Progress& progress);

/// That batches and groups are as FORMAT.md defines them: in canonical order, groups within batches, and no tetrahedron
/// that reaches from one group to another of its batch or dies in the batch that made it. For a history whose indices
/// can be followed.
Status verifyGroups(const Model& model, std::vector<std::string>& failures, const Progress& progress);

/// Of histories that are not Delaunay: the tetrahedra that a group makes stand on faces of those that it destroys and
/// on no others, so that a closed set, which has those, has a mesh. For a history whose indices can be followed.
Status verifyClosure(const Model& model, std::vector<std::string>& failures, const Progress& progress);

/// One for each sample that its error is multiplied by (R6); empty if the model was built without.
using Weights = std::vector<float>;

/// The weights that the model's parameters name, for the original's samples. What cannot be read is a failure.
Result<Weights> weightsOf(const Model& model, const Dataset& original, std::vector<std::string>& failures,
                          const Progress& progress);

/// One level, proved from the file's arrays and the original samples alone. `lifted`: of curvilinear data.
Result<LevelReport> verifyLevel(const Model& model, const Dataset& original, const CurvilinearOriginal* lifted,
                                const std::vector<LatticePoint>& places, const Weights& weights, const Accuracy& asked,
                                const Progress& progress);

/// For messages: "(3, 0, 17)".
std::string textOf(const LatticePoint& point);
std::string textOf(const CellCorners& corners);
/// For messages: shortest form, independent of the locale.
std::string textOf(double number);

} // namespace tetra
