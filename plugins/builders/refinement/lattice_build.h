// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/weighting.h"
#include "plugins/api/builder.h"

#include <string>

namespace tetra {

/// What a person asks of the refinement of a regular lattice.
struct LatticeBuildRequest {
    double error = 0;                ///< where to stop, in % of the value range
    std::string block = "automatic"; ///< the value of blockParameter()
    Weighting weighting;
};

/// The builder's work on regular lattices (R8), as a whole or in blocks (R10).
Acceptance acceptLattice(const Dataset& dataset);
Result<BuildReport> buildLattice(const Dataset& dataset, const LatticeBuildRequest& request, BuildTarget& target,
                                 const Progress& progress);

} // namespace tetra
