// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/images/images_parameters.h"

#include "plugins/api/placement_parameters.h"

#include <iterator>

namespace tetra {
namespace {

Parameter textParameter(std::string id, MarkedText label, MarkedText explanation)
{
    Parameter parameter;
    parameter.id = std::move(id);
    parameter.label = label;
    parameter.explanation = explanation;
    parameter.defaultValue = std::string();
    return parameter;
}

/// Empty if the text can be a component: "magnitude", a whole number from 0, or nothing.
Message componentMistake(const std::string& text)
{
    const bool isNumber = text.size() < 9 && text.find_first_not_of("0123456789") == std::string::npos;
    return text == "magnitude" || isNumber
               ? Message()
               : Message::say("Give '%1', or the number of a component from 0.", "magnitude");
}

} // namespace

std::vector<Parameter> imagesParameters()
{
    const Parameter series = textParameter(
        "series", Message::marked("Series"),
        Message::marked(
            "A folder with several DICOM series, or an OME file with several images: which one, by number from 1, by "
            "its description or name, or by its SeriesInstanceUID; by default that of the file, or the first."));
    const Parameter channel = textParameter(
        "channel", Message::marked("Channel"),
        Message::marked(
            "Pictures with several channels: one of them, by name or number from 1; by default the first."));
    Parameter component =
        textParameter("component", Message::marked("Component"),
                      Message::marked("Colour pictures: the number of one colour, from 0, or 'magnitude'."));
    component.mistake = componentMistake;
    Parameter time;
    time.id = "time";
    time.label = Message::marked("Time step");
    time.explanation = Message::marked("Pictures at several times, or several volumes at one place: which one, from 1; "
                                       "0 takes the first, or for DICOM files the one of the file.");
    time.defaultValue = std::int64_t(0);
    time.minimum = 0;
    time.maximum = 1e9;
    std::vector<Parameter> all{series, channel, component, time};
    std::ranges::move(placementParameters(), std::back_inserter(all));
    return all;
}

ImagesRequest imagesRequest(const ParameterValues& values)
{
    const auto all = imagesParameters();
    ImagesRequest request;
    request.series = parameterValue<std::string>(all, values, "series");
    request.channel = parameterValue<std::string>(all, values, "channel");
    request.component = parameterValue<std::string>(all, values, "component");
    request.time = parameterValue<std::int64_t>(all, values, "time");
    return request;
}

} // namespace tetra
