// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/model.h>
#include <tan/query.h>

namespace tetra {

/// The limits of a query in the units of a model: of the values, and of length. Infinite where there is none.
struct UnitLimits {
    double error = 0;
    double warping = 0;
};

UnitLimits unitLimits(const Model& model, const Accuracy& accuracy);

/// Whether the limits have the ratio that the model's history is ordered by (S4), up to `tolerance`: then no set of
/// sites that keeps both is much smaller than the prefix. Always without warping.
bool isInRatio(const Model& model, const UnitLimits& limits, double tolerance = 1e-3);

} // namespace tetra
