// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>

#include <optional>

namespace tetra {

/// The two thresholds that end a build (R7, R12): `error` in % of the value range, `warping` in % of the diagonal. One
/// alone holds for both; without either there is no threshold.
struct BuildThresholds {
    double error = 0;
    double warping = 0;
};

/// The thresholds in the units of a dataset, as one key of error and weighted warping (S4, S10).
struct ThresholdKey {
    double valueExtent = 1;    ///< what 100 % of the error are
    double positionExtent = 1; ///< and of the warping
    double warpingWeight = 1;  ///< what a length is worth in values: 1 % is worth 1 %, unless the thresholds say else
    std::optional<double> stopKey{};
};

inline ThresholdKey thresholdKey(const BuildThresholds& given, const Dataset& dataset)
{
    const double error = given.error > 0 ? given.error : given.warping;
    const double warping = given.warping > 0 ? given.warping : given.error;
    // A constant field has no range and coinciding points have no diagonal; any unit will do for what is 0 anyway.
    const auto unitOf = [](double extent) { return extent > 0 ? extent : 1; };
    ThresholdKey key;
    key.valueExtent = unitOf(dataset.values.range().extent());
    key.positionExtent = unitOf(dataset.bounds().diagonal().norm());
    key.warpingWeight = key.valueExtent / key.positionExtent;
    if (error > 0) {
        key.warpingWeight *= error / warping;
        key.stopKey = error / 100 * key.valueExtent;
    }
    return key;
}

} // namespace tetra
