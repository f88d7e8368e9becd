// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/weighting.h"
#include "core/refine/curvilinear/curvilinear_mesh.h"
#include "plugins/api/builder.h"
#include "plugins/api/threshold_parameters.h"

namespace tetra {

/// What a person asks of the refinement of a curvilinear grid.
struct CurvilinearBuildRequest {
    BuildThresholds thresholds;
    CurvilinearSelection selection = CurvilinearSelection::Normalised;
    std::uint32_t blockEdge = 0; ///< cells along an edge of a block, or 0 for no blocks
    Weighting weighting{};       ///< of errors and warpings (R6)
};

/// The builder's work on curvilinear and rectilinear grids (R8, R9).
Acceptance acceptCurvilinear(const Dataset& dataset);
/// Without thresholds the whole history is built.
Result<BuildReport> buildCurvilinear(const Dataset& dataset, const CurvilinearBuildRequest& request,
                                     BuildTarget& target, const Progress& progress);

} // namespace tetra
