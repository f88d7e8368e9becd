// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/time_choice.h"

#include "core/base/text.h"
#include "plugins/host/dataset_opening.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <vector>

namespace tetra {
namespace {

constexpr std::string_view ofTime = "t=";

/// The number after "t="; a number that is none is no time.
std::optional<double> timeIn(std::string_view text)
{
    const auto time =
        text.starts_with(ofTime) ? parseNumber<double>(text.substr(ofTime.size())) : std::optional<double>();
    return time && std::isfinite(*time) ? time : std::nullopt;
}

Error ofFile(const std::filesystem::path& path, const Message& why)
{
    return {ErrorKind::WrongUsage, Message::say("Cannot read '%1': %2", path.string(), why), path};
}

/// Of times that there are.
Result<std::int64_t> stepAt(double time, std::span<const double> times)
{
    constexpr double digits = 1e-9; // of times as `tan info` and the window tell them
    const auto nearest = std::ranges::min_element(times, {}, [&](double one) { return std::abs(one - time); });
    if (std::abs(*nearest - time) > digits * std::max(std::abs(*nearest), std::abs(time)))
        return Error{ErrorKind::WrongUsage,
                     Message::say("it has no time step at %1. The nearest one is number %2, at %3.", formatNumber(time),
                                  nearest - times.begin() + 1, formatNumber(*nearest))};
    return nearest - times.begin() + 1;
}

} // namespace

bool isTimeInWords(std::string_view text)
{
    return !parseNumber<std::int64_t>(text);
}

Result<std::int64_t> timeStepOf(PluginHost& host, const std::filesystem::path& path, const ImportOptions& options,
                                std::string_view text, const Progress& progress)
{
    const auto time = timeIn(text);
    if (text == "first")
        return std::int64_t(1);
    if (text != "last" && !time)
        return Error{
            ErrorKind::WrongUsage,
            Message::say("'%1' for '--time' is not understood. Give the number of a time step, from 1, 'first', "
                         "'last', or a time, as in t=0.25.",
                         printable(text))};
    ImportOptions others = options;
    others.values.erase("time");
    const auto contents = probeDataset(host, path, others, progress);
    if (!contents)
        return contents.error();
    const std::vector<double>& times = contents->timeSteps;
    const bool hasSteps =
        std::ranges::find(contents->taken, TakenPart::TimeStep, &Taken::part) != contents->taken.end();
    if (times.empty() && hasSteps)
        return ofFile(path, Message::say("it has more time steps than can be listed. Give the number of one, from 1, "
                                         "for '--time'."));
    if (!time)
        return std::max<std::int64_t>(1, std::ssize(times));
    if (times.empty())
        return ofFile(path, Message::say("it has one time step, and states no time. Leave '--time' out."));
    const auto step = stepAt(*time, times);
    return step ? step : ofFile(path, step.error().message);
}

} // namespace tetra
