// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/base.h>
#include <tan/data.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tetra {

/// For readers of data whose files may not say where they lie: "spacing" and "origin" of lattices and "unit", by which
/// the user does.

inline Parameter unitParameter()
{
    Parameter unit;
    unit.id = "unit";
    unit.label = Message::marked("Unit of length");
    unit.explanation = Message::marked(
        "Files that do not state it: the unit of coordinates, such as mm. It is displayed; nothing is converted.");
    unit.defaultValue = std::string();
    return unit;
}

inline std::vector<Parameter> placementParameters()
{
    Parameter spacing, origin;
    spacing.id = "spacing";
    spacing.label = Message::marked("Spacing");
    spacing.explanation = Message::marked("Files that do not state it, including raw ones: the distance between "
                                          "neighbouring points along x, y and z, as in 1x1x2.5; by default 1.");
    spacing.defaultValue = std::string();
    origin.id = "origin";
    origin.label = Message::marked("Origin");
    origin.explanation =
        Message::marked("Files that do not state it: the position of the first point, as in 10,20,-5; by default 0.");
    origin.defaultValue = std::string();
    return {spacing, origin, unitParameter()};
}

/// Three numbers with 'x', commas or blanks between them.
template <class Number> Result<std::array<Number, 3>> parseThree(const std::string& id, std::string_view text)
{
    constexpr std::string_view separators = "xX*, \t";
    std::string_view rest = text;
    std::array<Number, 3> numbers{};
    bool understood = true;
    for (Number& number : numbers) {
        rest.remove_prefix(std::min(rest.find_first_not_of(separators), rest.size()));
        const std::string_view word = rest.substr(0, rest.find_first_of(separators));
        const auto parsed = parseNumber<Number>(word);
        understood = understood && parsed;
        number = parsed.value_or(Number{});
        rest.remove_prefix(word.size());
    }
    if (!understood || rest.find_first_not_of(separators) != std::string_view::npos)
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' for '%2' is not understood. Give three numbers, along x, y and z, as in %3.",
                                  printable(text), id, std::is_integral_v<Number> ? "64x64x32" : "0.7x0.7x1.25")};
    return numbers;
}

/// What the user says; empty without a value, as fields of a form are that nobody has filled in.
inline std::string placementText(const ParameterValues& values, const std::string& id)
{
    const auto found = values.find(id);
    const auto* text = found != values.end() ? std::get_if<std::string>(&found->second) : nullptr;
    const bool isSaid = text != nullptr && text->find_first_not_of(" \t") != std::string::npos;
    return isSaid ? *text : std::string();
}

inline Result<std::optional<Eigen::Vector3d>> placementValue(const ParameterValues& values, const std::string& id)
{
    const std::string text = placementText(values, id);
    if (text.empty())
        return std::optional<Eigen::Vector3d>();
    const auto numbers = parseThree<double>(id, text);
    if (!numbers)
        return numbers.error();
    return std::optional(Eigen::Vector3d((*numbers)[0], (*numbers)[1], (*numbers)[2]));
}

/// Of these parameters those that a file leaves to the user, for FileContents::untold.
inline std::vector<std::string> untoldPlacement(bool tellsSpacing, bool tellsOrigin, bool tellsUnit)
{
    std::vector<std::string> untold;
    if (!tellsSpacing)
        untold.emplace_back("spacing");
    if (!tellsOrigin)
        untold.emplace_back("origin");
    if (!tellsUnit)
        untold.emplace_back("unit");
    return untold;
}

/// Of these parameters those that the user gives.
inline std::vector<std::string> givenPlacement(const ParameterValues& values)
{
    std::vector<std::string> given;
    for (const Parameter& parameter : placementParameters())
        if (!placementText(values, parameter.id).empty())
            given.push_back(parameter.id);
    return given;
}

/// An error (WrongUsage), a sentence about "it", for what the file tells itself.
inline Status checkUntold(const std::vector<std::string>& given, const std::vector<std::string>& untold)
{
    for (const std::string& id : given)
        if (std::ranges::find(untold, id) == untold.end())
            return Error{
                ErrorKind::WrongUsage,
                Message::say(
                    "it states its %1 itself. Leave '--%1' out; 'tan set-frame' changes it in the model of a lattice.",
                    id)};
    return {};
}

/// Puts data where the user says they lie. Errors (WrongUsage), each a sentence about "it": a value that is not
/// understood, or that the file tells itself.
inline Status placeByUser(const ParameterValues& values, const std::vector<std::string>& untold, Lattice& lattice,
                          std::string& lengthUnit)
{
    if (const Status fits = checkUntold(givenPlacement(values), untold); !fits)
        return fits;
    const auto spacing = placementValue(values, "spacing");
    if (!spacing)
        return spacing.error();
    const auto origin = placementValue(values, "origin");
    if (!origin)
        return origin.error();
    lattice.spacing = spacing->value_or(lattice.spacing);
    lattice.origin = origin->value_or(lattice.origin);
    if (const std::string unit = placementText(values, "unit"); !unit.empty())
        lengthUnit = unit;
    return {};
}

/// For Dataset::remarks of a lattice: nothing if the file or the user tells the spacing.
inline std::vector<Message> remarkOnSpacing(const ParameterValues& values, const std::vector<std::string>& untold,
                                            const Lattice& lattice)
{
    if (!placementText(values, "spacing").empty() || std::ranges::find(untold, "spacing") == untold.end())
        return {};
    std::string steps;
    for (const double step : lattice.spacing)
        steps += (steps.empty() ? "" : " x ") + formatNumber(step);
    return {Message::say("The file does not state its spacing: %1 is assumed. Give it with '--spacing' or in Import "
                         "Options, or afterwards with 'tan set-frame'.",
                         steps)};
}

} // namespace tetra
