// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/hdf5/hdf5_parameters.h"

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

bool isNumber(const std::string& text)
{
    return !text.empty() && text.size() < 9 && text.find_first_not_of("0123456789") == std::string::npos;
}

/// Empty if the text can be a component: "magnitude" or a whole number from 0.
Message componentMistake(const std::string& text)
{
    return text == "magnitude" || isNumber(text)
               ? Message()
               : Message::say("Give '%1', or the number of a component from 0.", "magnitude");
}

Message channelMistake(const std::string& text)
{
    return text.empty() || isNumber(text) ? Message() : Message::say("Give the number of a channel, from 1.");
}

Message indexMistake(const std::string& text)
{
    const auto parsed = parseFurtherDimensions(text);
    return parsed ? Message() : parsed.error().message;
}

} // namespace

std::vector<Parameter> hdf5Parameters()
{
    const Parameter array = parameterOf(
        "array", Message::marked("Array"),
        Message::marked("The array to take, by its path in the file, as in /fields/density, or by number; 'automatic' "
                        "takes the one that the file shows first (NeXus), else the largest."),
        std::string("automatic"));
    Parameter component =
        parameterOf("component", Message::marked("Component"),
                    Message::marked("Arrays with several components: the number of one, from 0, or 'magnitude'."),
                    std::string("magnitude"));
    component.mistake = componentMistake;
    Parameter time =
        parameterOf("time", Message::marked("Time step"),
                    Message::marked("Arrays with several time steps: which one, from 1."), std::int64_t(1));
    time.minimum = 1;
    time.maximum = 1e9;
    Parameter channel =
        parameterOf("channel", Message::marked("Channel"),
                    Message::marked("Arrays with several channels: the number of one, from 1; by default the first."),
                    std::string());
    channel.mistake = channelMistake;
    Parameter index = parameterOf("index", Message::marked("Further dimensions"),
                                  Message::marked("Arrays with more dimensions than space, time and channels: the "
                                                  "number along each, from 1, as in d2=3; by default the first."),
                                  std::string());
    index.mistake = indexMistake;
    std::vector<Parameter> all{array, component, time, channel, index};
    std::ranges::move(placementParameters(), std::back_inserter(all));
    return all;
}

Hdf5Request hdf5Request(const ParameterValues& values)
{
    const auto all = hdf5Parameters();
    Hdf5Request request;
    request.array = parameterValue<std::string>(all, values, "array");
    request.component = parameterValue<std::string>(all, values, "component");
    request.componentIsGiven = values.contains("component");
    request.timeStep = parameterValue<std::int64_t>(all, values, "time");
    request.timeIsGiven = values.contains("time");
    request.channel = parameterValue<std::string>(all, values, "channel");
    request.index = parameterValue<std::string>(all, values, "index");
    return request;
}

} // namespace tetra
