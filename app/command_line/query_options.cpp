// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/query_options.h"

#include "app/command_line/focus_option.h"
#include "app/command_line/option_values.h"
#include "core/history/query_words.h"

#include <tan/query.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace tetra {
namespace {

/// The choice that an option names, or the first one.
template <class Choice, std::size_t count>
Result<Choice> chosen(const Arguments& arguments, std::string_view option, const std::array<const char*, count>& words)
{
    const auto given = arguments.value(option);
    if (!given)
        return Choice();
    if (const auto choice = choiceOf<Choice>(words, *given))
        return *choice;
    std::string names;
    for (const char* word : words)
        names += (names.empty() ? "" : ", ") + std::string(word);
    return Error{ErrorKind::WrongUsage,
                 "'" + *given + "' does not fit '--" + std::string(option) + "': it takes one of " + names + "."};
}

/// --field, which says all of the error.
Result<FocusedFields> writtenField(const Arguments& arguments, const PresentView& present)
{
    for (const char* option : {"error", "focus", "focus-error", "focus-warping", "falloff"})
        if (arguments.has(option))
            return Error{ErrorKind::WrongUsage, "'--field' says where which error is allowed, so '--" +
                                                    std::string(option) + "' does not go with it."};
    const auto error = parseErrorField(*arguments.value("field"), present);
    if (!error)
        return Error{ErrorKind::WrongUsage, "'--field': " + error.error().text()};
    if (!arguments.has("warping"))
        return FocusedFields{*error, *error};
    const auto warping = limitOption(arguments, "warping", anyWarping);
    if (!warping)
        return warping.error();
    return FocusedFields{*error, *warping};
}

Result<FocusedFields> fieldsOf(const Arguments& arguments, const PresentView& present)
{
    if (arguments.has("field"))
        return writtenField(arguments, present);
    auto accuracy = accuracyOption(arguments);
    if (!accuracy)
        return accuracy.error();
    // A budget alone asks for the best mesh that it allows.
    if (arguments.has("budget") && !arguments.has("error") && !arguments.has("focus")) {
        accuracy->error = 0;
        accuracy->warping = arguments.has("warping") ? accuracy->warping : 0;
    }
    return focusedFields(arguments, accuracy->error, accuracy->warping);
}

Result<std::optional<std::uint64_t>> budgetOf(const Arguments& arguments)
{
    constexpr std::int64_t most = 1'000'000'000'000;
    if (!arguments.has("budget"))
        return std::optional<std::uint64_t>();
    const auto budget = wholeNumberOption(arguments, "budget", 0, 1, most);
    if (!budget)
        return budget.error();
    return std::optional(static_cast<std::uint64_t>(*budget));
}

/// How accurate one mesh is, and where.
std::vector<Option> fieldOptions()
{
    Option error = errorOption();
    error.byDefault += ", or with --budget and without a focus 0";
    std::vector<Option> options = {error, warpingOption()};
    std::ranges::move(focusOptions(), std::back_inserter(options));
    options.push_back(
        {.name = "field",
         .placeholder = "TEXT",
         .explanation =
             "In place of --error and --focus, the largest error at each place as an "
             "expression, such as 'min(sphere(5,5,5, 2; 0.5, 4, 1), isovalues(100; 0.1, 4, "
             "20))'; the manual explains it under 'The command line'. Unless --warping is given, the warping "
             "is limited by the same numbers."});
    options.push_back({.name = "budget",
                       .placeholder = "N",
                       .explanation = "At most so many tetrahedra: errors and warpings that are asked for are all "
                                      "multiplied by the smallest number, at least 1, that makes it possible."});
    options.push_back({.name = "method",
                       .placeholder = "NAME",
                       .explanation =
                           "How a mesh of varying accuracy, or of an error and a warping apart, is found: closed-set, "
                           "insertion (into the coarse mesh: one sharp focus in a lattice, any in a grid), or "
                           "automatic, the smaller one.",
                       .byDefault = "automatic"});
    return options;
}

/// Many meshes in place of one.
std::vector<Option> rangeOptions()
{
    return {{.name = "range",
             .placeholder = "A,B",
             .explanation = "In place of --error, all tetrahedra that are in the mesh of some error from A to B, each "
                            "with its life: the arrays birth_error and death_error."},
            {.name = "births",
             .placeholder = "LO,HI",
             .explanation = "Of a range, only tetrahedra that live from an error above LO and up to HI on; HI may be "
                            "inf."},
            {.name = "deaths",
             .placeholder = "LO,HI",
             .explanation = "Of a range, only tetrahedra that are replaced at an error from LO to HI."}};
}

std::vector<Option> partOptions()
{
    return {{.name = "window",
             .placeholder = "X0,Y0,Z0,X1,Y1,Z1",
             .explanation = "Only what lies in this box, given by two opposite corners in the data's own coordinates."},
            {.name = "border",
             .placeholder = "KIND",
             .explanation = "What becomes of tetrahedra at the window's border: intersecting keeps all that have a "
                            "point in common with it, contained those that lie in it whole, clipped cuts them off.",
             .byDefault = "intersecting"},
            {.name = "values",
             .placeholder = "LO,HI",
             .explanation = "Only tetrahedra that can contain a value from LO to HI.",
             .repeatable = true}};
}

/// Two numbers, the smaller one first.
Result<ValueRange> orderedPair(std::string_view option, const std::string& given, double least, double most)
{
    const auto ends = parseNumbers(option, given, least, most);
    if (!ends || ends->size() != 2 || ends->front() > ends->back())
        return Error{ErrorKind::WrongUsage, "'" + given + "' does not fit '--" + std::string(option) +
                                                "': it takes two numbers, the smaller one first: LO,HI."};
    return ValueRange{ends->front(), ends->back()};
}

Status checkRangeStandsAlone(const Arguments& arguments)
{
    for (const Option& option : fieldOptions())
        if (option.name != "warping" && arguments.has(option.name))
            return Error{ErrorKind::WrongUsage, "'--range' asks for tetrahedra of many accuracies, so '--" +
                                                    option.name + "' does not go with it."};
    if (arguments.value("border") == "clipped")
        return Error{ErrorKind::WrongUsage, "'--border clipped' does not go with '--range': what is cut off is no "
                                            "tetrahedron of the model. Use intersecting or contained."};
    return {};
}

/// --range: two errors, in any order.
Result<std::optional<LifeRange>> rangeOf(const Arguments& arguments)
{
    for (const char* option : {"births", "deaths"})
        if (arguments.has(option) && !arguments.has("range"))
            return Error{ErrorKind::WrongUsage, "'--" + std::string(option) +
                                                    "' chooses from a range of accuracies: say which with '--range'."};
    if (!arguments.has("range"))
        return std::optional<LifeRange>();
    if (const Status alone = checkRangeStandsAlone(arguments); !alone)
        return alone.error();
    const std::string given = *arguments.value("range");
    const auto errors = parseNumbers("range", given, 0, 100);
    if (!errors)
        return errors.error();
    if (errors->size() != 2)
        return Error{ErrorKind::WrongUsage,
                     "'" + given + "' does not fit '--range': it takes two errors in %, such as 4,1."};
    LifeRange range;
    for (std::size_t end = 0; end < 2; ++end) {
        const auto warping = limitOption(arguments, "warping", (*errors)[end]);
        if (!warping)
            return warping.error();
        (end == 0 ? range.one : range.other) = {.error = (*errors)[end], .warping = *warping};
    }
    constexpr double most = std::numeric_limits<double>::infinity();
    for (const auto& [option, lives] : {std::pair{"births", &range.births}, std::pair{"deaths", &range.deaths}})
        if (const auto text = arguments.value(option)) {
            const auto ends = orderedPair(option, *text, 0, most);
            if (!ends)
                return ends.error();
            *lives = *ends;
        }
    return std::optional(range);
}

Result<std::optional<Window>> windowOf(const Arguments& arguments)
{
    const auto given = arguments.value("window");
    if (!given && arguments.has("border"))
        return Error{ErrorKind::WrongUsage, "'--border' needs a window: say which with '--window'."};
    if (!given)
        return std::optional<Window>();
    const auto box = parseBox("window", *given);
    if (!box)
        return box.error();
    const auto border = chosen<WindowBorder>(arguments, "border", borderWords);
    if (!border)
        return border.error();
    return std::optional(Window{*box, *border});
}

Result<std::vector<ValueRange>> valueRangesOf(const Arguments& arguments)
{
    constexpr double most = std::numeric_limits<double>::max();
    std::vector<ValueRange> ranges;
    for (const std::string& given : arguments.values("values")) {
        const auto ends = orderedPair("values", given, -most, most);
        if (!ends)
            return ends.error();
        ranges.push_back(*ends);
    }
    return ranges;
}

} // namespace

std::vector<Option> queryOptions()
{
    std::vector<Option> all;
    for (auto options : {fieldOptions(), rangeOptions(), partOptions()})
        std::ranges::move(options, std::back_inserter(all));
    return all;
}

bool asksForMesh(const Arguments& arguments)
{
    return std::ranges::any_of(
        queryOptions(), [&](const Option& option) { return option.name != "warping" && arguments.has(option.name); });
}

PresentView anyView()
{
    return {Eigen::Vector3d(0, 0, 0), {0}, {{0, 1}}};
}

Result<MeshQuery> queryOf(const Arguments& arguments, const PresentView& present)
{
    MeshQuery query;
    const auto range = rangeOf(arguments);
    if (!range)
        return range.error();
    query.range = *range;
    const auto fields =
        query.range ? Result<FocusedFields>(FocusedFields{0, anyWarping}) : fieldsOf(arguments, present);
    if (!fields)
        return fields.error();
    query.error = fields->error;
    query.warping = fields->warping;
    const auto budget = budgetOf(arguments);
    if (!budget)
        return budget.error();
    query.budget = *budget;
    const auto values = valueRangesOf(arguments);
    if (!values)
        return values.error();
    query.values = *values;
    const auto window = windowOf(arguments);
    if (!window)
        return window.error();
    query.window = *window;
    const auto method = chosen<VariableMethod>(arguments, "method", methodWords);
    if (!method)
        return method.error();
    query.method = *method;
    if (arguments.has("method") && query.error.isConstant() && query.warping == query.error)
        return Error{ErrorKind::WrongUsage, "'--method' is for meshes whose accuracy varies: say where with '--focus' "
                                            "or '--field', or give '--error' and '--warping' limits of their own."};
    return query;
}

} // namespace tetra
