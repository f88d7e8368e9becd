// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/model/extraction.h"
#include "core/model/queries/mesh_query.h"

namespace tetra {

/// An error (WrongUsage) that says what to change if the query makes no sense for any mesh of the model: not a number,
/// a box or range upside down, a budget of nothing.
Status checkQuery(const Model& model, const MeshQuery& query);

/// ExtractedMesh::scale of a uniform mesh.
double scaleReached(const MeshSize& size, const Accuracy& asked);

} // namespace tetra
