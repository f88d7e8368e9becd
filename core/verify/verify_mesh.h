// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/dataset.h"
#include "core/history/model.h"
#include "core/history/query/mesh_query.h"
#include "core/verify/verification.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

/// Proves of a mesh of the whole domain, whatever made it (a field, a budget), what verify() proves of a level: it is a
/// conforming, exact cover of the domain without flat or inverted cells, its vertices are points of the dataset with
/// the dataset's values, and at each original sample its error and its warping are at most query.error and
/// query.warping there, at mesh.scale (keptPercent()). `asked` is what it must keep everywhere, and
/// `largestError` the largest one found. Shares no code with
/// extraction. The query has no values and no window. What it needs of the model are its sites, their running errors
/// and, of scattered data, that its first mesh fills the domain, which verify() proves. An Error only if checking
/// itself was impossible.
Result<LevelReport> verifyMesh(const Model& model, const Dataset& original, const MeshQuery& query,
                               const ExtractedMesh& mesh, const Progress& progress = {});

/// The dataset's point that each vertex of an extracted mesh is, for verification: the point of its site, or the one
/// that the mesh names. Position and value must be the dataset's, rounded to float, and no two vertices the same point;
/// what is not so is a failure. Empty if a vertex is no point.
std::vector<std::uint32_t> pointsOfVertices(const Model& model, const Dataset& original, const ExtractedMesh& mesh,
                                            std::vector<std::string>& failures);

} // namespace tetra
