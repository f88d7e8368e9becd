// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/builder.h"

namespace tetra {

/// What refining data of this size takes; not of irregular ones. `inBlocks`: of regular lattices.
BuildEstimate estimateRefinement(const BuildSize& size, bool inBlocks, unsigned threads);

} // namespace tetra
