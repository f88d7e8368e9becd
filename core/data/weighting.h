// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>

#include <span>

namespace tetra {

/// As pointWeights(), into `weights`, one a point, wherever these lie. Errors: cancelled.
Status weighPoints(const Weighting& weighting, const Dataset& dataset, std::span<float> weights,
                   const Progress& progress);

} // namespace tetra
