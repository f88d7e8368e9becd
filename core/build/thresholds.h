// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/build.h>
#include <tan/data.h>

#include <algorithm>
#include <optional>

namespace tetra {

/// The two thresholds that end a build (R7, R12): `error` in % of the value range, `warping` in % of the diagonal. One
/// alone holds for both; without either there is no threshold. Ordered by one of the two (C1), the other has none.
struct BuildThresholds {
    double error = 0;
    double warping = 0;
    OrderedBy orderedBy = OrderedBy::Both;
};

/// The thresholds in the units of a dataset, as one key of error and weighted warping (S4, S10).
struct ThresholdKey {
    double valueExtent = 1;    ///< what 100 % of the error are
    double positionExtent = 1; ///< and of the warping
    double warpingWeight = 1;  ///< what a length is worth in values: 1 % is worth 1 %, unless the thresholds say else
    double keyExtent = 1;      ///< the key of 100 %
    double leastKey = 0;       ///< a mesh of no larger key is exact in what counts
    std::optional<double> stopKey{};
};

/// A threshold of what does not count would be ignored.
inline Status checkThresholds(const BuildThresholds& given, const Dataset& dataset)
{
    const bool warps = dataset.domain == DomainClass::Curvilinear || dataset.domain == DomainClass::Irregular;
    if (warps && given.orderedBy == OrderedBy::Error && given.warping > 0)
        return Error{
            ErrorKind::WrongUsage,
            Message::say(
                "A build ordered by the error alone has no threshold of warping. Leave that out, or order by both.")};
    if (warps && given.orderedBy == OrderedBy::Warping && given.error > 0)
        return Error{
            ErrorKind::WrongUsage,
            Message::say(
                "A build ordered by the warping alone has no threshold of error. Leave that out, or order by both.")};
    return {};
}

inline ThresholdKey thresholdKey(const BuildThresholds& given, const Dataset& dataset)
{
    // A constant field has no range and coinciding points have no diagonal; any unit will do for what is 0 anyway.
    const auto unitOf = [](double extent) { return extent > 0 ? extent : 1; };
    ThresholdKey key;
    key.valueExtent = unitOf(dataset.values.range().extent());
    key.positionExtent = unitOf(dataset.bounds().diagonal().norm());
    key.warpingWeight = key.valueExtent / key.positionExtent;
    key.keyExtent = key.valueExtent;
    const double error = given.error > 0 ? given.error : given.warping;
    const double warping = given.warping > 0 ? given.warping : given.error;
    if (given.orderedBy != OrderedBy::Both) {
        // Keys need a weight: all that there can be of what does not count is worth less than any difference that
        // matters in the other one.
        constexpr double nothing = 0x1p-40;
        const bool byError = given.orderedBy == OrderedBy::Error;
        key.warpingWeight *= byError ? nothing : 1 / nothing;
        key.keyExtent *= byError ? 1 : 1 / nothing;
        key.leastKey = nothing * key.keyExtent;
    } else if (error > 0) {
        key.warpingWeight *= error / warping;
    }
    if (error > 0)
        key.stopKey = std::max(error / 100 * key.keyExtent, key.leastKey);
    return key;
}

} // namespace tetra
