// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/option_values.h"

#include "app/command_line/table.h"
#include "core/base/text.h"
#include "core/history/value_statistics.h"

#include <algorithm>
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

/// What a value in standard deviations is, and of what they are.
std::string deviationsText(const ValueStatistics& statistics, const std::string& given, double value)
{
    const char* const of = statistics.of == ValueStatistics::Of::Samples
                               ? ", both of all samples."
                               : ", both over the volume of the finest mesh that was read.";
    return given + " is " + formatNumber(value) + ": the mean is " + rounded(statistics.mean) +
           " and the standard deviation " + rounded(statistics.deviation) + of;
}

/// Where the value of an entry of a list ends.
std::string_view valueIn(std::string_view entry)
{
    return entry.substr(0, entry.find(':'));
}

/// The entries of a list, and what is between them.
template <class Change> std::string changedEntries(std::string_view list, const Change& change)
{
    std::string changed;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        changed += (begin > 0 ? "," : "") + change(list.substr(begin, end - begin));
        begin = end + 1;
    }
    return changed;
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

namespace {

Result<double> parseLimit(std::string_view option, std::string_view given)
{
    static_assert(anyError == anyWarping);
    return given == "none" ? anyError : parseBounded<double>(option, given, 0, anyError, "'none' or a number");
}

/// A level of a list: an error that holds for the warping, too, unless that is given, or both as "1:5".
Result<Accuracy> parseLevel(const Arguments& arguments, std::string_view given)
{
    const std::size_t colon = given.find(':');
    const auto error = parseLimit("lod", given.substr(0, colon));
    if (!error)
        return error.error();
    const auto warping = colon == std::string_view::npos ? limitOption(arguments, "warping", *error)
                                                         : parseLimit("lod", given.substr(colon + 1));
    if (!warping)
        return warping.error();
    return Accuracy{.error = *error, .warping = *warping};
}

} // namespace

Result<double> limitOption(const Arguments& arguments, std::string_view name, double byDefault)
{
    const auto given = arguments.value(name);
    return given ? parseLimit(name, *given) : byDefault;
}

std::string limitText(double percent)
{
    return percent >= anyError ? "none" : rounded(percent);
}

std::string levelText(const Accuracy& level)
{
    return level.error == level.warping ? limitText(level.error)
                                        : limitText(level.error) + ":" + limitText(level.warping);
}

Option errorOption()
{
    return {.name = "error",
            .placeholder = "PERCENT",
            .explanation = "The largest error that the mesh may have, in % of the data's value range, of the kind that "
                           "'tan info' names; 0 takes the finest mesh, 'none' sets no limit.",
            .byDefault = formatNumber(defaultError)};
}

Option warpingOption()
{
    return {.name = "warping",
            .placeholder = "PERCENT",
            .explanation =
                "For models of curvilinear and irregular data: the largest warping that the mesh may have, in "
                "% of the diagonal of the data's bounding box, whatever the error; 'none' sets no limit.",
            .byDefault = "the same number as the error"};
}

Status checkWarpingOption(const Arguments& arguments, const ModelDescription& model, const std::string& place)
{
    if (!arguments.has("warping") || model.warpingWeight > 0)
        return {};
    return Error{ErrorKind::WrongUsage,
                 "'--warping' is for models of curvilinear or irregular data only, and the data of '" + place +
                     "' cannot warp. Leave it out."};
}

Status checkWarpingOption(const Arguments& arguments, const Model& model)
{
    return checkWarpingOption(arguments, model.description(), model.path().string());
}

Result<Accuracy> accuracyOption(const Arguments& arguments)
{
    const auto error = limitOption(arguments, "error", defaultError);
    if (!error)
        return error.error();
    const auto warping = limitOption(arguments, "warping", *error);
    if (!warping)
        return warping.error();
    return Accuracy{.error = *error, .warping = *warping};
}

Result<Arguments> withValuesOfData(Arguments arguments, std::string_view option, const Model& model,
                                   const Progress& progress, std::vector<Message>& told)
{
    std::optional<ValueStatistics> statistics;
    for (auto& [name, list] : arguments.options) {
        if (name != option || list.find("sd") == std::string::npos)
            continue;
        if (!statistics) {
            const auto found = statisticsOf(model, progress);
            if (!found)
                return Error{found.error().kind,
                             "'--" + std::string(option) + " " + list + "': " + found.error().text()};
            statistics = *found;
        }
        list = changedEntries(list, [&](std::string_view entry) {
            const std::string given(valueIn(entry));
            const auto deviations = parseDeviations(given);
            if (!deviations)
                return std::string(entry);
            const double value = statistics->valueAt(*deviations);
            told.emplace_back(deviationsText(*statistics, given, value));
            return formatNumber(value) + std::string(entry.substr(given.size()));
        });
    }
    return arguments;
}

Option levelsOption()
{
    return {.name = "lod",
            .placeholder = "LIST",
            .explanation = "The levels of detail: errors in % of the data's value range, separated by commas; or pairs "
                           "of error and warping, such as 1:5 or none:1.",
            .byDefault = std::string(defaultLevels)};
}

Result<std::vector<Accuracy>> levelsOf(const Arguments& arguments)
{
    const std::string list = arguments.value("lod").value_or(std::string(defaultLevels));
    std::vector<Accuracy> levels;
    for (std::string_view rest = list;;) {
        const std::size_t end = rest.find(',');
        const auto level = parseLevel(arguments, rest.substr(0, end));
        if (!level)
            return level.error();
        levels.push_back(*level);
        if (end == std::string_view::npos)
            return levels;
        rest.remove_prefix(end + 1);
    }
}

Option threadsOption()
{
    return {.name = "threads",
            .placeholder = "N",
            .explanation = "Maximum number of threads.",
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
