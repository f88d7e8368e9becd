// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/verify.h>

#include <cstdint>
#include <optional>

namespace tetra {

/// The least accuracy that a mesh of this scale (keptPercent()) keeps at all samples.
TAN_INTERNAL Accuracy keptEverywhere(const MeshQuery& query, double scale);

/// Proves of a mesh of the whole domain, whatever made it (a field, a budget), what verify() proves of a level: it is a
/// conforming, exact cover of the domain without flat or inverted cells, its vertices are points of the dataset with
/// the dataset's values, and at each original sample its error and its warping are at most query.error and
/// query.warping there, at mesh.scale (keptPercent()). `asked` is what it must keep everywhere, and
/// `measured` what was found. Shares no code with extraction. The query has no values and no window. What it needs of
/// the model are its sites, their running keys and, of scattered data, that its first mesh fills the domain, which
/// verify() proves. An Error only if checking itself was impossible.
TAN_INTERNAL Result<LevelReport> verifyMesh(const Model& model, const Dataset& original, const MeshQuery& query,
                                            const ExtractedMesh& mesh, const Progress& progress = {});

/// Grids of more points are not measured in passing: it would take longer than people wait for a mesh.
inline constexpr std::uint64_t mostPointsInPassing = 500'000;

/// The error in space of a mesh whose model guarantees the one in the grid, at all samples of the dataset, which the
/// model itself has. Nothing where there is none to measure (ErrorMeaning), of a part of a mesh, where the model lacks
/// samples or there is no memory, and of more than `mostPointsInPassing`. It proves nothing: the mesh is taken as it
/// is. On all threads, O(tetrahedra + points) times the depth of trees of their boxes. Errors: a damaged file,
/// cancelled.
TAN_INTERNAL Result<std::optional<ErrorInSpace>>
measureInSpace(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh, const Progress& progress = {});

} // namespace tetra
