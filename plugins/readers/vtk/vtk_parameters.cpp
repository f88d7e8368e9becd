// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/vtk_parameters.h"

#include "plugins/api/cells_parameters.h"
#include "plugins/api/placement_parameters.h"

#include <algorithm>
#include <iterator>

namespace tetra {
namespace {

Parameter textParameter(std::string id, MarkedText label, MarkedText explanation, std::string defaultText)
{
    Parameter parameter;
    parameter.id = std::move(id);
    parameter.label = label;
    parameter.explanation = explanation;
    parameter.defaultValue = std::move(defaultText);
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

} // namespace

std::vector<Parameter> vtkParameters()
{
    Parameter array = textParameter(
        "array", Message::marked("Values"),
        Message::marked("The values to take, by name or number; 'automatic' takes the first."), "automatic");
    Parameter component = textParameter(
        "component", Message::marked("Component"),
        Message::marked("Arrays with several components: the number of one, from 0, or 'magnitude'."), "magnitude");
    component.mistake = componentMistake;
    Parameter time;
    time.id = "time";
    time.label = Message::marked("Time step");
    time.explanation = Message::marked("Files with several time steps: which one, from 1.");
    time.defaultValue = std::int64_t(1);
    time.minimum = 1;
    time.maximum = 1e9;
    Parameter part = textParameter("part", Message::marked("Part"),
                                   Message::marked("Files with several blocks or parts: one, by name or number from 1; "
                                                   "by default all volumes that have the values, as one mesh."),
                                   "");
    std::vector<Parameter> all{array, component, time, part};
    std::ranges::move(cellsParameters(), std::back_inserter(all));
    std::ranges::move(placementParameters(), std::back_inserter(all));
    return all;
}

VtkRequest vtkRequest(const ParameterValues& values)
{
    const auto all = vtkParameters();
    VtkRequest request;
    request.array = parameterValue<std::string>(all, values, "array");
    if (values.contains("component"))
        request.component = parameterValue<std::string>(all, values, "component");
    if (values.contains("time"))
        request.timeStep = parameterValue<std::int64_t>(all, values, "time");
    request.part = parameterValue<std::string>(all, values, "part");
    return request;
}

} // namespace tetra
