// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/data.h>

#include <string>
#include <utility>
#include <vector>

namespace tetra {

inline Parameter thresholdParameter(std::string id, MarkedText label, MarkedText explanation, MarkedText unit)
{
    Parameter parameter;
    parameter.id = std::move(id);
    parameter.label = label;
    parameter.explanation = explanation;
    parameter.unit = unit;
    parameter.defaultValue = 0.0;
    parameter.minimum = 0;
    parameter.maximum = 100;
    return parameter;
}

inline Parameter errorThresholdParameter(MarkedText explanation)
{
    return thresholdParameter("error", Message::marked("Error"), explanation, Message::marked("% of the value range"));
}

/// For data of these domains only.
inline Parameter warpingThresholdParameter(std::vector<DomainClass> domains)
{
    Parameter warping = thresholdParameter(
        "warping", Message::marked("Warping"),
        Message::marked(
            "For curvilinear and irregular data: the warping at which to stop. Its ratio to the error says how much "
            "the shape counts against the values. If one of the two is 0, it is the same number as the other."),
        Message::marked("% of the diagonal"));
    warping.onlyWith.id = domainId;
    for (const DomainClass domain : domains)
        warping.onlyWith.values.emplace_back(std::string(domainClassName(domain)));
    return warping;
}

} // namespace tetra
