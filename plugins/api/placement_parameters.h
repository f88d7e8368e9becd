// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/base.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// For readers of lattices whose files may not say where they lie: "spacing" and "origin", by which the user does.

inline std::vector<Parameter> placementParameters()
{
    Parameter spacing, origin;
    spacing.id = "spacing";
    spacing.label = Message::marked("Spacing");
    spacing.explanation = Message::marked("Files that do not tell it, raw ones among them: the distance of "
                                          "neighbouring points along x, y and z, as in 1x1x2.5.");
    spacing.defaultValue = std::string("1x1x1");
    origin.id = "origin";
    origin.label = Message::marked("Origin");
    origin.explanation = Message::marked("Files that do not tell it: the position of the first point, as in 0,0,0.");
    origin.defaultValue = std::string("0,0,0");
    return {spacing, origin};
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
        return Error{
            ErrorKind::WrongUsage,
            Message::say("'%1' for '%2' is not understood. Give three numbers, along x, y and z, as in 64x64x32.",
                         printable(text), id)};
    return numbers;
}

/// What the user says; nothing without a value.
inline Result<std::optional<Eigen::Vector3d>> placementValue(const ParameterValues& values, const std::string& id)
{
    const auto found = values.find(id);
    const auto* text = found != values.end() ? std::get_if<std::string>(&found->second) : nullptr;
    if (text == nullptr)
        return std::optional<Eigen::Vector3d>();
    const auto numbers = parseThree<double>(id, *text);
    if (!numbers)
        return numbers.error();
    return std::optional(Eigen::Vector3d((*numbers)[0], (*numbers)[1], (*numbers)[2]));
}

/// Of a file that says itself what the user gives; a sentence about "it".
inline Error placementIsKnown(const std::string& id)
{
    return {ErrorKind::WrongUsage,
            Message::say("it tells its %1 itself. Leave '--%1' out; 'tan set-frame' gives the model another one.", id)};
}

} // namespace tetra
