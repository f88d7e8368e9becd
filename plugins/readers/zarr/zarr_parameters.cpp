// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/zarr/zarr_parameters.h"

#include "plugins/api/placement_parameters.h"

#include <algorithm>
#include <iterator>
#include <string_view>

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

std::string_view withoutBlanks(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    return text.substr(0, text.find_last_not_of(" \t") + 1);
}

} // namespace

Result<std::map<std::string, std::uint64_t>> parseAxisNumbers(const std::string& text)
{
    std::map<std::string, std::uint64_t> numbers;
    for (std::string_view rest = withoutBlanks(text); !rest.empty();) {
        const std::string_view entry = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(entry.size() + 1, rest.size()));
        const auto sign = entry.find('=');
        const std::string name(withoutBlanks(entry.substr(0, sign)));
        const auto number = sign == std::string_view::npos
                                ? std::nullopt
                                : parseNumber<std::uint64_t>(withoutBlanks(entry.substr(sign + 1)));
        if (name.empty() || !number || *number == 0)
            return Error{ErrorKind::WrongUsage,
                         Message::say("'%1' for 'index' is not understood. Give the name of each axis with a number "
                                      "from 1, as in angle=3,type=1.",
                                      printable(text))};
        numbers[name] = *number;
    }
    return numbers;
}

std::vector<Parameter> zarrParameters()
{
    Parameter array = textParameter(
        "array", Message::marked("Values"),
        Message::marked(
            "Zarr groups: the array to take, or the image, by its path in the folder; 'automatic' takes the first."));
    array.defaultValue = std::string("automatic");
    const Parameter series = textParameter(
        "series", Message::marked("Series"),
        Message::marked("OME-Zarr with several images: one, by its path or number from 1; by default the first."));
    const Parameter part = textParameter(
        "part", Message::marked("Level"),
        Message::marked(
            "OME-Zarr: the level of detail, by its path or by its number, 0 being the finest, which is the default."));
    const Parameter channel = textParameter(
        "channel", Message::marked("Channel"),
        Message::marked(
            "Pictures with several channels: one of them, by name or number from 1; by default the first."));
    Parameter time;
    time.id = "time";
    time.label = Message::marked("Time step");
    time.explanation = Message::marked("Pictures at several times: which one, from 1; 0 takes the first.");
    time.defaultValue = std::int64_t(0);
    time.minimum = 0;
    time.maximum = 1e9;
    Parameter index = textParameter(
        "index", Message::marked("Further axes"),
        Message::marked(
            "Arrays with more axes than space, time and channels: the number along each, from 1, as in angle=3; an "
            "axis without a name is called by its number from 1. By default the first is taken."));
    index.mistake = [](const std::string& text) {
        const auto parsed = parseAxisNumbers(text);
        return parsed ? Message() : parsed.error().message;
    };
    std::vector<Parameter> all{array, series, part, channel, time, index};
    std::ranges::move(placementParameters(), std::back_inserter(all));
    return all;
}

ZarrRequest zarrRequest(const ParameterValues& values)
{
    const auto all = zarrParameters();
    ZarrRequest request;
    request.array = parameterValue<std::string>(all, values, "array");
    request.series = parameterValue<std::string>(all, values, "series");
    request.part = parameterValue<std::string>(all, values, "part");
    request.channel = parameterValue<std::string>(all, values, "channel");
    request.time = parameterValue<std::int64_t>(all, values, "time");
    request.index = parameterValue<std::string>(all, values, "index");
    return request;
}

} // namespace tetra
