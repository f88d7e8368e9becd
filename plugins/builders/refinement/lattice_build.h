// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/weighting.h"
#include "plugins/api/builder.h"

namespace tetra {

/// The builder's work on regular lattices (R8).
Acceptance acceptLattice(const Dataset& dataset);
/// `error`: where to stop, in % of the value range.
Result<BuildReport> buildLattice(const Dataset& dataset, double error, const Weighting& weighting, BuildTarget& target,
                                 const Progress& progress);

} // namespace tetra
