// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/decimation/decimated_mesh.h"

namespace tetra {

/// Collapses vertices, the one of the smallest exact key first, until none can go below `stopKey`. A queue whose
/// entries are looked at again when they come to its head after something around them has changed. Error: cancelled.
Status decimateByExactError(DecimatedMesh& mesh, double stopKey, const Progress& progress);

} // namespace tetra
