// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/weighting.h"
#include "plugins/api/builder.h"

namespace tetra {

/// The builder's work on scattered points (R1, R8): their convex hull is filled.
Acceptance acceptScattered(const Dataset& dataset);
/// `error`: where to stop, in % of the value range.
Result<BuildReport> buildScattered(const Dataset& dataset, double error, const Weighting& weighting,
                                   BuildTarget& target, const Progress& progress);

} // namespace tetra
