// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/netcdf/netcdf_parameters.h"

#include "plugins/api/cells_parameters.h"
#include "plugins/api/placement_parameters.h"
#include "plugins/process/further_dimensions.h"

#include <algorithm>
#include <iterator>

namespace tetra {
namespace {

Parameter parameterOf(std::string id, MarkedText label, MarkedText explanation, ParameterValue defaultValue)
{
    Parameter parameter;
    parameter.id = std::move(id);
    parameter.label = label;
    parameter.explanation = explanation;
    parameter.defaultValue = std::move(defaultValue);
    return parameter;
}

/// Empty if the text can be a component: "magnitude" or a whole number from 0.
Message componentMistake(const std::string& text)
{
    const bool isNumber = !text.empty() && text.size() < 9 && text.find_first_not_of("0123456789") == std::string::npos;
    return text == "magnitude" || isNumber
               ? Message()
               : Message::say("Give '%1', or the number of a component from 0.", "magnitude");
}

Message indexMistake(const std::string& text)
{
    const auto parsed = parseFurtherDimensions(text);
    return parsed ? Message() : parsed.error().message;
}

} // namespace

std::vector<Parameter> netCdfParameters()
{
    Parameter array = parameterOf("array", Message::marked("Values"),
                                  Message::marked("NetCDF and Exodus files: the variable, by name or number; "
                                                  "'automatic' takes the first that is not constant."),
                                  std::string("automatic"));
    Parameter component = parameterOf(
        "component", Message::marked("Component"),
        Message::marked("Exodus variables with several components: the number of one, from 0, or 'magnitude'."),
        std::string("magnitude"));
    component.mistake = componentMistake;
    Parameter time = parameterOf("time", Message::marked("Time step"),
                                 Message::marked("Files with several time steps: which one, from 1."), std::int64_t(1));
    time.minimum = 1;
    time.maximum = 1e9;
    Parameter index = parameterOf("index", Message::marked("Further dimensions"),
                                  Message::marked("Variables with more dimensions than space and time: the number "
                                                  "along each, from 1, as in member=3; by default the first."),
                                  std::string());
    index.mistake = indexMistake;
    Parameter part = parameterOf("part", Message::marked("Part"),
                                 Message::marked("Exodus files: one element block, by its name, its number from 1 or "
                                                 "its id; by default all that have the values."),
                                 std::string());
    Parameter displace =
        parameterOf("displace", Message::marked("Displace"),
                    Message::marked("Exodus files with displacements: moves the nodes by them."), false);
    std::vector<Parameter> all{array, component, time, index, part, displace};
    std::ranges::move(cellsParameters(), std::back_inserter(all));
    std::ranges::move(placementParameters(), std::back_inserter(all));
    return all;
}

NetCdfRequest netCdfRequest(const ParameterValues& values)
{
    const auto all = netCdfParameters();
    NetCdfRequest request;
    request.array = parameterValue<std::string>(all, values, "array");
    if (values.contains("component"))
        request.component = parameterValue<std::string>(all, values, "component");
    request.timeStep = parameterValue<std::int64_t>(all, values, "time");
    request.timeIsGiven = values.contains("time");
    request.index = parameterValue<std::string>(all, values, "index");
    request.part = parameterValue<std::string>(all, values, "part");
    request.displaced = parameterValue<bool>(all, values, "displace");
    return request;
}

} // namespace tetra
