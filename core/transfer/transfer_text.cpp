// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/transfer_text.h"

#include "core/base/json_writer.h"

#include <tan/transfer.h>

#include <algorithm>
#include <initializer_list>

namespace tetra {
namespace {

constexpr std::string_view formatName = "tan-transfer-function";
constexpr int formatVersion = 2;
constexpr int versionOfPoints = 1; ///< a colour and an opacity at each value
constexpr MarkedText wholeText = Message::marked("the text");

Error wrongFunction(const JsonValue& value, const Message& what)
{
    return {ErrorKind::BadInput,
            Message::say("The transfer function cannot be read: %1 (%2).", what, describePlace(value.place))};
}

template <class Number> Status readNumber(const JsonValue& value, const Message& name, Number& number)
{
    const JsonValue::Number* text = value.number();
    const auto parsed = text != nullptr ? parseNumber<Number>(text->text) : std::nullopt;
    if (!parsed)
        return wrongFunction(value, Message::say("%1 must be a number within range", name));
    number = *parsed;
    return {};
}

Status checkMembers(const JsonValue& object, std::initializer_list<std::string_view> needed,
                    std::initializer_list<std::string_view> optional, const Message& what)
{
    if (object.object() == nullptr)
        return wrongFunction(object, Message::say("%1 must be an object, in braces", what));
    for (const std::string_view name : needed)
        if (object.find(name) == nullptr)
            return wrongFunction(object, Message::say("%1 has no \"%2\"", what, name));
    for (const auto& [name, value] : *object.object())
        if (std::ranges::find(needed, name) == needed.end() && std::ranges::find(optional, name) == optional.end())
            return wrongFunction(value, Message::say("\"%1\" is not known here", printable(name)));
    return {};
}

Status readColour(const JsonValue& value, std::array<float, 3>& colour)
{
    const JsonArray* channels = value.array();
    if (channels == nullptr || channels->size() != colour.size())
        return wrongFunction(value, Message::say("a colour must be three numbers in brackets"));
    for (std::size_t channel = 0; channel < colour.size(); ++channel)
        if (Status status = readNumber((*channels)[channel], Message::marked("a channel"), colour[channel]); !status)
            return status;
    return {};
}

/// What all points have.
template <class Point> Status readPlace(const JsonValue& value, Point& point)
{
    if (Status status = readNumber(*value.find("value"), "\"value\"", point.value); !status)
        return status;
    if (const JsonValue* group = value.find("group"))
        return readNumber(*group, "\"group\"", point.group.emplace());
    return {};
}

Status readPoint(const JsonValue& value, ColourPoint& point)
{
    if (Status status = checkMembers(value, {"value", "colour"}, {"group"}, Message::marked("a colour")); !status)
        return status;
    if (Status status = readPlace(value, point); !status)
        return status;
    return readColour(*value.find("colour"), point.colour);
}

Status readPoint(const JsonValue& value, OpacityPoint& point)
{
    if (Status status = checkMembers(value, {"value", "opacity"}, {"group"}, Message::marked("an opacity")); !status)
        return status;
    if (Status status = readPlace(value, point); !status)
        return status;
    return readNumber(*value.find("opacity"), "\"opacity\"", point.opacity);
}

Status readPoint(const JsonValue& value, TransferPoint& point)
{
    if (Status status = checkMembers(value, {"value", "colour", "opacity"}, {"group"}, Message::marked("a point"));
        !status)
        return status;
    if (Status status = readPlace(value, point); !status)
        return status;
    if (Status status = readNumber(*value.find("opacity"), "\"opacity\"", point.opacity); !status)
        return status;
    return readColour(*value.find("colour"), point.colour);
}

template <class Point> Status readPoints(const JsonValue& root, std::string_view name, std::vector<Point>& points)
{
    const JsonValue& list = *root.find(name);
    if (list.array() == nullptr)
        return wrongFunction(list, Message::say("\"%1\" must be a list, in brackets", name));
    for (const JsonValue& value : *list.array())
        if (Status status = readPoint(value, points.emplace_back()); !status)
            return status;
    return {};
}

Status readMask(const JsonValue& value, TransferMask& mask)
{
    if (Status status = checkMembers(value, {"least", "largest"}, {}, Message::marked("a mask")); !status)
        return status;
    if (Status status = readNumber(*value.find("least"), "\"least\"", mask.least); !status)
        return status;
    if (Status status = readNumber(*value.find("largest"), "\"largest\"", mask.largest); !status)
        return status;
    if (Status status = checkMask(mask); !status)
        return wrongFunction(value, status.error().message);
    return {};
}

Status readFormat(const JsonValue& root, int& version)
{
    if (root.object() == nullptr)
        return wrongFunction(root, Message::say("%1 must be an object, in braces", wholeText));
    for (const std::string_view name : {"format", "version"})
        if (root.find(name) == nullptr)
            return wrongFunction(root, Message::say("%1 has no \"%2\"", wholeText, name));
    const std::string* format = root.find("format")->string();
    if (format == nullptr || *format != formatName)
        return wrongFunction(*root.find("format"), Message::say("\"format\" is not \"%1\"", formatName));
    if (Status status = readNumber(*root.find("version"), "\"version\"", version); !status)
        return status;
    if (version != formatVersion && version != versionOfPoints)
        return wrongFunction(*root.find("version"), Message::say("this program knows versions 1 to %1", formatVersion));
    return {};
}

std::string lookText(const ColourPoint& point)
{
    const auto& [red, green, blue] = point.colour;
    return "\"colour\": [" + formatNumber(red) + ", " + formatNumber(green) + ", " + formatNumber(blue) + "]";
}

std::string lookText(const OpacityPoint& point)
{
    return "\"opacity\": " + formatNumber(point.opacity);
}

template <class Point> std::string listText(const std::vector<Point>& points)
{
    std::string text = "[";
    std::string_view separator = "\n";
    for (const Point& point : points) {
        text += separator;
        text += "    {\"value\": " + formatNumber(point.value) + ", " + lookText(point) +
                (point.group ? ", \"group\": " + std::to_string(*point.group) : "") + "}";
        separator = ",\n";
    }
    return text + "\n  ]";
}

std::string maskText(const TransferMask& mask)
{
    return "{\"least\": " + formatNumber(mask.least) + ", \"largest\": " + formatNumber(mask.largest) + "}";
}

} // namespace

std::string transferFunctionToText(const TransferFunction& function)
{
    return "{\n  \"format\": " + jsonString(formatName) + ",\n  \"version\": " + std::to_string(formatVersion) +
           ",\n  \"unitDistance\": " + formatNumber(function.unitDistance) +
           (function.mask ? ",\n  \"mask\": " + maskText(*function.mask) : "") +
           ",\n  \"colours\": " + listText(function.colours) + ",\n  \"opacities\": " + listText(function.opacities) +
           "\n}\n";
}

Result<TransferFunction> transferFunctionFromText(std::string_view text)
{
    const Result<JsonValue> parsed = parseJson(text);
    if (!parsed)
        return Error{ErrorKind::BadInput,
                     Message::say("The transfer function cannot be read. %1", parsed.error().message)};
    return transferFunctionFromJson(*parsed);
}

Result<TransferFunction> transferFunctionFromJson(const JsonValue& root)
{
    int version = 0;
    if (Status status = readFormat(root, version); !status)
        return status.error();
    TransferFunction function;
    if (version == versionOfPoints) {
        if (Status status = checkMembers(root, {"format", "version", "points"}, {"unitDistance", "mask"}, wholeText);
            !status)
            return status.error();
        std::vector<TransferPoint> points;
        if (Status status = readPoints(root, "points", points); !status)
            return status.error();
        function = transferFunctionFromPoints(points);
        if (Status status = checkTransferFunction(function); !status)
            return wrongFunction(*root.find("points"), status.error().message);
    } else {
        if (Status status =
                checkMembers(root, {"format", "version", "colours", "opacities"}, {"unitDistance", "mask"}, wholeText);
            !status)
            return status.error();
        if (Status status = readPoints(root, "colours", function.colours); !status)
            return status.error();
        if (Status status = checkTransferFunction(function); !status)
            return wrongFunction(*root.find("colours"), status.error().message);
        if (Status status = readPoints(root, "opacities", function.opacities); !status)
            return status.error();
        if (Status status = checkTransferFunction(function); !status)
            return wrongFunction(*root.find("opacities"), status.error().message);
    }
    if (const JsonValue* distance = root.find("unitDistance"))
        if (Status status = readNumber(*distance, "\"unitDistance\"", function.unitDistance); !status)
            return status.error();
    if (const JsonValue* mask = root.find("mask"))
        if (Status status = readMask(*mask, function.mask.emplace()); !status)
            return status.error();
    if (Status status = checkTransferFunction(function); !status)
        return wrongFunction(root, status.error().message);
    return function;
}

} // namespace tetra
