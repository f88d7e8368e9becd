// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/option_values.h"

#include "core/base/text.h"

#include <type_traits>

namespace tetra {
namespace {

constexpr std::string_view defaultLevels = "4,3,2,1,.5,.2,.1,0";
constexpr double defaultError = 1;
constexpr std::int64_t mostThreads = 1024;

template <class T> std::string text(T number)
{
    if constexpr (std::is_integral_v<T>)
        return std::to_string(number);
    else
        return formatNumber(number);
}

template <class T>
Result<T> parseBounded(std::string_view option, std::string_view given, T least, T most, std::string_view what)
{
    const auto number = parseNumber<T>(given);
    if (number && *number >= least && *number <= most) // a NaN is not
        return *number;
    return Error{ErrorKind::WrongUsage, "'" + std::string(given) + "' does not fit '--" + std::string(option) +
                                            "': it takes " + std::string(what) + " from " + text(least) + " to " +
                                            text(most) + "."};
}

} // namespace

Result<double> numberOption(const Arguments& arguments, std::string_view name, double byDefault, double least,
                            double most)
{
    const auto given = arguments.value(name);
    return given ? parseBounded<double>(name, *given, least, most, "a number") : byDefault;
}

Result<std::int64_t> wholeNumberOption(const Arguments& arguments, std::string_view name, std::int64_t byDefault,
                                       std::int64_t least, std::int64_t most)
{
    const auto given = arguments.value(name);
    return given ? parseBounded<std::int64_t>(name, *given, least, most, "a whole number") : byDefault;
}

Result<std::vector<double>> parseNumbers(std::string_view option, std::string_view list, double least, double most)
{
    std::vector<double> numbers;
    for (;;) {
        const auto end = list.find(',');
        const auto number =
            parseBounded<double>(option, list.substr(0, end), least, most, "numbers, separated by commas,");
        if (!number)
            return number.error();
        numbers.push_back(*number);
        if (end == std::string_view::npos)
            return numbers;
        list.remove_prefix(end + 1);
    }
}

Option errorOption()
{
    return {.name = "error",
            .placeholder = "PERCENT",
            .explanation = "The largest error that the mesh may have, in % of the data's range of values; 0 takes the "
                           "finest mesh.",
            .byDefault = formatNumber(defaultError)};
}

Option warpingOption()
{
    return {.name = "warping",
            .placeholder = "PERCENT",
            .explanation =
                "For models of curvilinear and irregular data: the largest warping that the mesh may have, in "
                "% of the diagonal of the data's bounding box; 100 sets no limit.",
            .byDefault = "the same number as the error"};
}

Status checkWarpingOption(const Arguments& arguments, const Model& model)
{
    if (!arguments.has("warping") || model.description().warpingWeight > 0)
        return {};
    return Error{ErrorKind::WrongUsage,
                 "'--warping' is for models of curvilinear or irregular data only, and the data of '" +
                     model.path().string() + "' cannot warp. Leave it out."};
}

Result<Accuracy> accuracyOption(const Arguments& arguments)
{
    const auto error = numberOption(arguments, "error", defaultError, 0, 100);
    if (!error)
        return error.error();
    const auto warping = numberOption(arguments, "warping", *error, 0, anyWarping);
    if (!warping)
        return warping.error();
    return Accuracy{.error = *error, .warping = *warping};
}

Option levelsOption()
{
    return {.name = "lod",
            .placeholder = "LIST",
            .explanation = "The levels of detail: errors in % of the data's range of values, separated by commas.",
            .byDefault = std::string(defaultLevels)};
}

Result<std::vector<Accuracy>> levelsOf(const Arguments& arguments)
{
    const auto errors = parseNumbers("lod", arguments.value("lod").value_or(std::string(defaultLevels)), 0, 100);
    if (!errors)
        return errors.error();
    std::vector<Accuracy> levels;
    for (const double error : *errors) {
        const auto warping = numberOption(arguments, "warping", error, 0, anyWarping);
        if (!warping)
            return warping.error();
        levels.push_back({.error = error, .warping = *warping});
    }
    return levels;
}

Option threadsOption()
{
    return {.name = "threads",
            .placeholder = "N",
            .explanation = "The most threads to use.",
            .byDefault = "as many as the machine has"};
}

Result<int> threadsOf(const Arguments& arguments)
{
    const auto threads = wholeNumberOption(arguments, "threads", 0, 1, mostThreads);
    if (!threads)
        return threads.error();
    return static_cast<int>(*threads);
}

Option outputOption(std::string placeholder, std::string explanation, bool required)
{
    return {.name = "output",
            .placeholder = std::move(placeholder),
            .explanation = std::move(explanation),
            .letter = 'o',
            .required = required};
}

} // namespace tetra
