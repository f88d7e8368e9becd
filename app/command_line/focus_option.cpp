// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/focus_option.h"

#include "app/command_line/option_values.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace tetra {
namespace {

constexpr std::string_view focusForms = "box:x0,y0,z0,x1,y1,z1 or sphere:x,y,z,r, with numbers and a radius above 0";

Error doesNotFit(std::string_view option, std::string_view given, std::string_view form)
{
    return {ErrorKind::WrongUsage, "'" + std::string(given) + "' does not fit '--" + std::string(option) +
                                       "': it takes " + std::string(form) + "."};
}

/// Exactly `count` finite numbers, separated by commas.
template <std::size_t count> std::optional<std::array<double, count>> finiteNumbers(std::string_view list)
{
    std::array<double, count> numbers{};
    for (std::size_t index = 0; index < count; ++index) {
        const bool isLast = index + 1 == count;
        const auto end = isLast ? list.size() : list.find(',');
        if (end == std::string_view::npos)
            return {};
        const auto number = parseNumber<double>(list.substr(0, end));
        if (!number || !std::isfinite(*number))
            return {};
        numbers[index] = *number;
        list.remove_prefix(isLast ? end : end + 1);
    }
    return numbers;
}

std::optional<Box> boxOf(std::string_view list)
{
    const auto n = finiteNumbers<6>(list);
    if (!n)
        return {};
    const Eigen::Vector3d one((*n)[0], (*n)[1], (*n)[2]);
    const Eigen::Vector3d other((*n)[3], (*n)[4], (*n)[5]);
    return Box{one.cwiseMin(other), one.cwiseMax(other)};
}

/// Inside of all the regions, each with its own fall-off; where several reach, the smaller number counts.
ErrorField fieldOf(const std::vector<Region>& regions, double inner, double outer, double falloff)
{
    ErrorField field = SpaceRamp{regions.front(), inner, outer, falloff};
    for (std::size_t number = 1; number < regions.size(); ++number)
        field = smallerOf(field, SpaceRamp{regions[number], inner, outer, falloff});
    return field;
}

Status checkSmaller(std::string_view what, double inner, double outer)
{
    if (inner <= outer)
        return {};
    return Error{ErrorKind::WrongUsage, "The " + std::string(what) + " in the focus, " + formatNumber(inner) +
                                            " %, is larger than the " + formatNumber(outer) +
                                            " % elsewhere. Exchange '--focus-" + std::string(what) + "' and '--" +
                                            std::string(what) + "', or write what you mean with '--field'."};
}

} // namespace

Result<Box> parseBox(std::string_view option, std::string_view text)
{
    const auto box = boxOf(text);
    return box ? Result<Box>(*box) : Result<Box>(doesNotFit(option, text, "two opposite corners: x0,y0,z0,x1,y1,z1"));
}

Result<Region> parseFocus(std::string_view text)
{
    constexpr std::string_view boxName = "box:";
    constexpr std::string_view sphereName = "sphere:";
    if (text.starts_with(boxName))
        if (const auto box = boxOf(text.substr(boxName.size())))
            return Region(*box);
    if (text.starts_with(sphereName))
        if (const auto n = finiteNumbers<4>(text.substr(sphereName.size())); n && (*n)[3] > 0)
            return Region(Sphere{{(*n)[0], (*n)[1], (*n)[2]}, (*n)[3]});
    return doesNotFit("focus", text, focusForms);
}

std::vector<Option> focusOptions()
{
    return {{.name = "focus",
             .placeholder = "REGION",
             .explanation = "Where the mesh is finer: box:x0,y0,z0,x1,y1,z1 or sphere:x,y,z,r, in the data's own "
                            "coordinates. Of several, the one with the smaller error counts.",
             .repeatable = true},
            {.name = "focus-error",
             .placeholder = "PERCENT",
             .explanation = "The largest error within the focus; --error holds elsewhere."},
            {.name = "focus-warping",
             .placeholder = "PERCENT",
             .explanation = "Likewise the largest warping; --warping holds elsewhere.",
             .byDefault = "the same number as the focus error, or the warping elsewhere if that is smaller"},
            {.name = "falloff",
             .placeholder = "LENGTH",
             .explanation = "The distance from the focus over which the error grows from the one to the other.",
             .byDefault = "0, a sharp border"}};
}

Result<FocusedFields> focusedFields(const Arguments& arguments, double error, double warping)
{
    if (!arguments.has("focus")) {
        for (const char* option : {"focus-error", "focus-warping", "falloff"})
            if (arguments.has(option))
                return Error{ErrorKind::WrongUsage,
                             "'--" + std::string(option) + "' needs a focus: say where with '--focus'."};
        return FocusedFields{error, warping};
    }
    if (!arguments.has("focus-error"))
        return Error{ErrorKind::WrongUsage,
                     "'--focus' needs '--focus-error PERCENT', the largest error within the focus."};
    std::vector<Region> regions;
    for (const std::string& text : arguments.values("focus")) {
        const auto region = parseFocus(text);
        if (!region)
            return region.error();
        regions.push_back(*region);
    }
    const auto innerError = limitOption(arguments, "focus-error", 0);
    if (!innerError)
        return innerError.error();
    // Unless it is asked for, a limit that holds everywhere is not relaxed in the focus.
    const auto innerWarping = limitOption(arguments, "focus-warping", std::min(*innerError, warping));
    if (!innerWarping)
        return innerWarping.error();
    const auto falloff = numberOption(arguments, "falloff", 0, 0, std::numeric_limits<double>::max());
    if (!falloff)
        return falloff.error();
    if (const Status smaller = checkSmaller("error", *innerError, error); !smaller)
        return smaller.error();
    if (const Status smaller = checkSmaller("warping", *innerWarping, warping); !smaller)
        return smaller.error();
    return FocusedFields{fieldOf(regions, *innerError, error, *falloff),
                         *innerWarping < warping ? fieldOf(regions, *innerWarping, warping, *falloff)
                                                 : ErrorField(warping)};
}

} // namespace tetra
