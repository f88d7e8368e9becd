// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/weighting.h"
#include "core/mesh/curvilinear_mesh.h"
#include "plugins/api/builder.h"

namespace tetra {

/// What a person asks of the refinement of a curvilinear grid.
struct CurvilinearBuildRequest {
    double error = 0;   ///< where to stop, in % of the value range
    double warping = 0; ///< where to stop, in % of the bounding box's diagonal
    CurvilinearSelection selection = CurvilinearSelection::Normalised;
    std::uint32_t blockEdge = 0; ///< cells along an edge of a block, or 0 for no blocks
    Weighting weighting{};       ///< of errors and warpings (R6)
};

/// The builder's work on curvilinear and rectilinear grids (R8, R9).
Acceptance acceptCurvilinear(const Dataset& dataset);
/// Both thresholds above 0: their ratio says what a warping is worth in errors. Else 1 % of the diagonal is worth 1 %
/// of the value range; and since a threshold of 0 is met by nothing less, the whole history is built then.
Result<BuildReport> buildCurvilinear(const Dataset& dataset, const CurvilinearBuildRequest& request,
                                     BuildTarget& target, const Progress& progress);

} // namespace tetra
