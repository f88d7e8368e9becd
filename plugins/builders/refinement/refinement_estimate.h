// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/builder.h"

namespace tetra {

/// What refining data of this size takes, down to an error that is a share of the range (and the diagonal); not of
/// irregular ones. `inBlocks`: of regular lattices.
BuildEstimate estimateRefinement(const BuildSize& size, double error, bool inBlocks, unsigned threads);

} // namespace tetra
