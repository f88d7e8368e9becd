// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/decimation/decimated_mesh.h"

namespace tetra {

/// Collapses vertices, the one of the smallest exact key first, until none can go below `stopKey`. A queue whose
/// entries are looked at again when they come to its head after something around them has changed. Error: cancelled.
Status decimateByExactError(DecimatedMesh& mesh, double stopKey, const Progress& progress);

/// The paper's order (R11): each vertex goes onto the neighbour of the most similar gradient, the most similar ones
/// first; boundary vertices of irregular meshes by their distance from the plane that fits their boundary neighbours
/// best. The exact key is tested before a collapse is done (S11); a vertex that cannot go is looked at again when its
/// star has changed. Error: cancelled.
Status decimateByEstimates(DecimatedMesh& mesh, double warpingWeight, double stopKey, const Progress& progress);

/// Rounds of collapses whose stars share no tetrahedron, smallest exact key first; a round has the keys up to a bound
/// that is doubled when nothing below it is left. The dependencies of the history are as shallow as the rounds are few.
/// Error: cancelled.
Status decimateInRounds(DecimatedMesh& mesh, double stopKey, const Progress& progress);

} // namespace tetra
