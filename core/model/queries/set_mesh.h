// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/model.h"
#include "core/model/queries/closed_set.h"
#include "core/model/queries/field_judge.h"

namespace tetra {

/// Takes the mesh of a closed set out of the file: vertices are its sites, ascending, tetrahedra come by creator. The
/// buffers of `out` are used again. `places` of all its sites. Errors: a damaged file, cancelled.
Status extractSet(const Model& model, const ClosedSet& set, const SitePlaces& places, const Progress& progress,
                  ExtractedMesh& out);

} // namespace tetra
