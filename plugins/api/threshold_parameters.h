// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset.h"
#include "plugins/api/parameter.h"

#include <optional>

namespace tetra {

/// The two thresholds that end a build (R7, R12): "error" in % of the value range, "warping" in % of the diagonal.
/// One alone holds for both; without either there is no threshold.
struct BuildThresholds {
    double error = 0;
    double warping = 0;
};

inline Parameter thresholdParameter(std::string id, std::string label, std::string explanation, std::string unit)
{
    Parameter parameter;
    parameter.id = std::move(id);
    parameter.label = std::move(label);
    parameter.explanation = std::move(explanation);
    parameter.unit = std::move(unit);
    parameter.defaultValue = 0.0;
    parameter.minimum = 0;
    parameter.maximum = 100;
    return parameter;
}

inline Parameter errorThresholdParameter(std::string explanation)
{
    return thresholdParameter("error", "Error", std::move(explanation), "% of the value range");
}

/// For data of these domains only.
inline Parameter warpingThresholdParameter(std::vector<DomainClass> domains)
{
    Parameter warping = thresholdParameter(
        "warping", "Warping",
        "For curvilinear and irregular data: the warping at which to stop. Its ratio to the error says how much the "
        "shape counts against the values. If one of the two is 0, it is the same number as the other.",
        "% of the diagonal");
    warping.onlyWith.id = domainId;
    for (const DomainClass domain : domains)
        warping.onlyWith.values.emplace_back(std::string(domainClassName(domain)));
    return warping;
}

inline BuildThresholds buildThresholds(const std::vector<Parameter>& parameters, const ParameterValues& values)
{
    BuildThresholds thresholds{parameterValue<double>(parameters, values, "error"),
                               parameterValue<double>(parameters, values, "warping")};
    if (!(thresholds.warping > 0))
        thresholds.warping = thresholds.error;
    if (!(thresholds.error > 0))
        thresholds.error = thresholds.warping;
    return thresholds;
}

/// The thresholds in the units of a dataset, as one key of error and weighted warping (S4, S10).
struct ThresholdKey {
    double valueExtent = 1;    ///< what 100 % of the error are
    double positionExtent = 1; ///< and of the warping
    double warpingWeight = 1;  ///< what a length is worth in values: 1 % is worth 1 %, unless the thresholds say else
    std::optional<double> stopKey{};
};

inline ThresholdKey thresholdKey(const BuildThresholds& thresholds, const Dataset& dataset)
{
    // A constant field has no range and coinciding points have no diagonal; any unit will do for what is 0 anyway.
    const auto unitOf = [](double extent) { return extent > 0 ? extent : 1; };
    ThresholdKey key;
    key.valueExtent = unitOf(dataset.values.range().extent());
    key.positionExtent = unitOf(dataset.bounds().diagonal().norm());
    key.warpingWeight = key.valueExtent / key.positionExtent;
    if (thresholds.error > 0) {
        key.warpingWeight *= thresholds.error / thresholds.warping;
        key.stopKey = thresholds.error / 100 * key.valueExtent;
    }
    return key;
}

} // namespace tetra
