// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/build.h>
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

/// For data of these domains only, by domainNameOf().
inline Parameter warpingThresholdParameter(const std::vector<std::string>& domains)
{
    Parameter warping = thresholdParameter(
        "warping", Message::marked("Warping"),
        Message::marked(
            "For data whose domain can warp: the warping at which to stop. Its ratio to the error sets how much the "
            "shape counts against the values. If one of the two is 0, it is the same number as the other."),
        Message::marked("% of the diagonal"));
    warping.onlyWith.id = domainId;
    warping.onlyWith.values.assign(domains.begin(), domains.end());
    return warping;
}

/// By what the history of data that can warp is ordered (C1). For data of these domains only.
inline Parameter orderedByParameter(const std::vector<std::string>& domains)
{
    Parameter by;
    by.id = "by";
    by.label = Message::marked("Ordered by");
    by.explanation = Message::marked("For data whose domain can warp: 'both' orders the model by the larger of error "
                                     "and warping, in the ratio of their thresholds; 'error' or 'warping' by that "
                                     "alone, for the fewest points where the other one does not matter.");
    by.choices = {std::string(Message::marked("both")), std::string(Message::marked("error")),
                  std::string(Message::marked("warping"))};
    by.defaultValue = by.choices.front();
    by.onlyWith.id = domainId;
    by.onlyWith.values.assign(domains.begin(), domains.end());
    return by;
}

inline OrderedBy orderedByOf(const std::vector<Parameter>& parameters, const ParameterValues& values)
{
    const std::string by = parameterValue<std::string>(parameters, values, "by");
    return by == "error" ? OrderedBy::Error : by == "warping" ? OrderedBy::Warping : OrderedBy::Both;
}

} // namespace tetra
