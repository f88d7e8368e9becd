// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/parameter_text.h"

#include "core/base/text.h"
#include "core/data/value_scale.h"
#include "plugins/host/colour_text.h"

#include <tan/transfer.h>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    for (;;) {
        const auto end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos)
            return parts;
        text.remove_prefix(end + 1);
    }
}

bool isBounded(const Parameter& parameter)
{
    return parameter.maximum > parameter.minimum;
}

bool isWithinBounds(const Parameter& parameter, double number)
{
    return !isBounded(parameter) || (number >= parameter.minimum && number <= parameter.maximum);
}

Error notIn(const Parameter& parameter, std::string_view text)
{
    return {ErrorKind::WrongUsage,
            Message::say("'%1' does not fit '%2': it takes %3.", text, parameter.id, parameterDomain(parameter))};
}

template <class T> Result<ParameterValue> parseNumberOf(const Parameter& parameter, std::string_view text)
{
    const auto number = parseNumber<T>(text);
    if (!number || !std::isfinite(static_cast<double>(*number)) ||
        !isWithinBounds(parameter, static_cast<double>(*number)))
        return notIn(parameter, text);
    return ParameterValue(*number);
}

Result<ParameterValue> parseIsovalues(const Parameter& parameter, std::string_view text)
{
    std::vector<Isovalue> isovalues;
    for (const std::string_view part : split(text, ',')) {
        const auto isovalue = parseIsovalue(part);
        if (!isovalue)
            return isovalue.error();
        if (!isWithinBounds(parameter, isovalue->value))
            return notIn(parameter, part);
        isovalues.push_back(*isovalue);
        if (part.find(':') == std::string_view::npos) { // told apart from those before it
            const Colour colour = surfaceColour(isovalues.size() - 1);
            isovalues.back().red = colour.red;
            isovalues.back().green = colour.green;
            isovalues.back().blue = colour.blue;
        }
    }
    return ParameterValue(isovalues);
}

Result<ParameterValue> parseVector(const Parameter& parameter, std::string_view text)
{
    const auto parts = split(text, ',');
    if (parts.size() != 3)
        return notIn(parameter, text);
    Eigen::Vector3d vector;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto number = parseNumber<double>(parts[axis]);
        if (!number || !std::isfinite(*number) || !isWithinBounds(parameter, *number))
            return notIn(parameter, text);
        vector[static_cast<Eigen::Index>(axis)] = *number;
    }
    return ParameterValue(vector);
}

std::string isovalueText(const Isovalue& isovalue)
{
    return formatNumber(isovalue.value) + ":" + colourText({isovalue.red, isovalue.green, isovalue.blue}) + ":" +
           formatNumber(isovalue.opacity);
}

/// How a value is called, by its type.
struct TypeName {
    Message operator()(bool) const { return Message::say("true or false"); }
    Message operator()(std::int64_t) const { return Message::say("a whole number"); }
    Message operator()(double) const { return Message::say("a number"); }
    Message operator()(const std::string&) const { return Message::say("a text"); }
    Message operator()(const std::vector<Isovalue>&) const
    {
        return Message::say("isovalues %1", "V[:COLOUR[:OPACITY]], V");
    }
    Message operator()(const TransferFunction&) const { return Message::say("a transfer function as JSON"); }
    Message operator()(const Colour&) const { return Message::say("a colour, #rrggbb or a name"); }
    Message operator()(const Eigen::Vector3d&) const { return Message::say("three numbers x,y,z"); }
    Message operator()(const OwnValue& value) const { return Message::say("text that describes %1", value.type); }
};

struct ToText {
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(double value) const { return formatNumber(value); }
    std::string operator()(const std::string& value) const { return value; }
    std::string operator()(const std::vector<Isovalue>& values) const
    {
        std::string text;
        for (const Isovalue& isovalue : values)
            text += (text.empty() ? "" : ",") + isovalueText(isovalue);
        return text;
    }
    std::string operator()(const TransferFunction& function) const { return transferFunctionToText(function); }
    std::string operator()(const Colour& colour) const { return colourText(colour); }
    std::string operator()(const Eigen::Vector3d& vector) const
    {
        return formatNumber(vector[0]) + "," + formatNumber(vector[1]) + "," + formatNumber(vector[2]);
    }
    std::string operator()(const OwnValue& value) const { return value.text; }
};

} // namespace

Result<Isovalue> parseIsovalue(std::string_view text)
{
    const auto parts = split(text, ':');
    const Error wrong{ErrorKind::WrongUsage,
                      Message::say("'%1' is not an isovalue. Give VALUE, VALUE:COLOUR or VALUE:COLOUR:OPACITY, the "
                                   "opacity above 0 and at most 1: 128:#ff8000:0.5",
                                   text)};
    const auto value = parseFieldValue(parts[0]);
    if (!value || parts.size() > 3)
        return wrong;
    Isovalue isovalue{.value = *value};
    if (parts.size() > 1) {
        const auto colour = parseColour(parts[1]);
        if (!colour)
            return colour.error();
        isovalue.red = colour->red;
        isovalue.green = colour->green;
        isovalue.blue = colour->blue;
    }
    if (parts.size() > 2) {
        const auto opacity = parseNumber<float>(parts[2]);
        if (!opacity || !(*opacity > 0 && *opacity <= 1))
            return wrong;
        isovalue.opacity = *opacity;
    }
    return isovalue;
}

Result<ParameterValue> parseParameter(const Parameter& parameter, std::string_view text)
{
    if (std::holds_alternative<bool>(parameter.defaultValue)) {
        if (text != "true" && text != "false")
            return notIn(parameter, text);
        return ParameterValue(text == "true");
    }
    if (std::holds_alternative<std::int64_t>(parameter.defaultValue))
        return parseNumberOf<std::int64_t>(parameter, text);
    if (std::holds_alternative<double>(parameter.defaultValue))
        return parseNumberOf<double>(parameter, text);
    if (std::holds_alternative<std::vector<Isovalue>>(parameter.defaultValue))
        return parseIsovalues(parameter, text);
    if (std::holds_alternative<TransferFunction>(parameter.defaultValue)) {
        auto function = transferFunctionFromText(text);
        if (!function)
            return function.error();
        return ParameterValue(*std::move(function));
    }
    if (std::holds_alternative<Colour>(parameter.defaultValue)) {
        const auto colour = parseColour(text);
        return colour ? Result<ParameterValue>(ParameterValue(*colour)) : colour.error();
    }
    if (std::holds_alternative<Eigen::Vector3d>(parameter.defaultValue))
        return parseVector(parameter, text);
    if (!parameter.choices.empty() && std::ranges::find(parameter.choices, text) == parameter.choices.end())
        return notIn(parameter, text);
    if (parameter.mistake)
        if (const Message mistake = parameter.mistake(std::string(text)); !mistake.empty())
            return Error{ErrorKind::WrongUsage, mistake};
    if (const auto* own = std::get_if<OwnValue>(&parameter.defaultValue))
        return ParameterValue(OwnValue{own->type, std::string(text)});
    return ParameterValue(std::string(text));
}

std::string parameterText(const ParameterValue& value)
{
    return std::visit(ToText(), value);
}

Message parameterDomain(const Parameter& parameter)
{
    std::string choices;
    for (const std::string& choice : parameter.choices)
        choices += (choices.empty() ? "" : ", ") + choice;
    Message domain =
        choices.empty() ? std::visit(TypeName(), parameter.defaultValue) : Message::say("one of %1", choices);
    const auto bound = [&](double number) {
        return std::holds_alternative<std::int64_t>(parameter.defaultValue)
                   ? std::to_string(static_cast<std::int64_t>(number)) // not 1e+09
                   : formatNumber(number);
    };
    if (isBounded(parameter))
        domain = Message::say("%1 from %2 to %3", domain, bound(parameter.minimum), bound(parameter.maximum));
    if (!parameter.unit.empty())
        domain = Message::say("%1, in %2", domain, Message::of(parameter.unit, {}));
    return domain;
}

} // namespace tetra
