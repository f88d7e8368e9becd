// SPDX-License-Identifier: GPL-3.0-or-later
// The text of how a mesh is drawn: the members "look" and "isovalues" of a view.
#include "core/view/view_text.h"

#include "core/transfer/transfer_text.h"

#include <tan/transfer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tetra {
namespace {

/// A whole number, or 0 if there is none in 64 bits.
std::int64_t integerOf(const JsonValue::Number& number)
{
    constexpr double most = 0x1p63;
    if (const auto integer = parseNumber<std::int64_t>(number.text))
        return *integer;
    const double wide = parseNumber<double>(number.text).value_or(0);
    return std::abs(wide) < most && wide == std::trunc(wide) ? static_cast<std::int64_t>(wide) : 0;
}

/// As it says its type itself.
JsonValue settingToJson(const ParameterValue& value)
{
    const auto tagged = [](const char* tag, JsonValue content) { return JsonObject{{tag, std::move(content)}}; };
    if (const bool* truth = std::get_if<bool>(&value))
        return *truth;
    if (const std::int64_t* integer = std::get_if<std::int64_t>(&value))
        return tagged("integer", *integer);
    if (const double* number = std::get_if<double>(&value))
        return tagged("number", *number);
    if (const std::string* text = std::get_if<std::string>(&value))
        return *text;
    if (const Colour* colour = std::get_if<Colour>(&value))
        return tagged("colour", toJson(*colour));
    if (const Eigen::Vector3d* vector = std::get_if<Eigen::Vector3d>(&value))
        return tagged("vector", jsonThree(*vector));
    if (const OwnValue* own = std::get_if<OwnValue>(&value))
        return JsonObject{{"type", own->type}, {"text", own->text}};
    if (const auto* isovalues = std::get_if<std::vector<Isovalue>>(&value))
        return tagged("isovalues", toJson(*isovalues));
    return tagged("transfer", toJson(std::get<TransferFunction>(value)));
}

/// Nothing of what is no setting that this program knows.
std::optional<ParameterValue> settingOf(const JsonValue& value)
{
    if (const bool* truth = std::get_if<bool>(&value.content))
        return ParameterValue(*truth);
    if (const std::string* text = value.string())
        return ParameterValue(*text);
    std::optional<Error> error;
    const JsonFields fields(&value, {}, error);
    const JsonValue *const integer = fields.find("integer"), *const type = fields.find("type"),
                           *const text = fields.find("text");
    if (integer != nullptr && integer->number() != nullptr)
        return ParameterValue(integerOf(*integer->number()));
    if (const auto number = JsonFields::numberOf(fields.find("number")))
        return ParameterValue(*number);
    if (const auto colour = JsonFields::threeOf(fields.find("colour")))
        return ParameterValue(Colour{static_cast<float>((*colour)[0]), static_cast<float>((*colour)[1]),
                                     static_cast<float>((*colour)[2])});
    if (const auto vector = JsonFields::threeOf(fields.find("vector")))
        return ParameterValue(Eigen::Vector3d((*vector)[0], (*vector)[1], (*vector)[2]));
    if (type != nullptr && type->string() != nullptr && text != nullptr && text->string() != nullptr)
        return ParameterValue(OwnValue{*type->string(), *text->string()});
    ParameterValue setting;
    if (fields.has("isovalues"))
        readIsovalues(fields, setting.emplace<std::vector<Isovalue>>());
    else if (fields.has("transfer"))
        readTransfer(fields, setting.emplace<TransferFunction>());
    else
        return std::nullopt;
    return error ? std::nullopt : std::optional(setting);
}

} // namespace

JsonValue toJson(const Colour& colour)
{
    return jsonThree(std::array{colour.red, colour.green, colour.blue});
}

Colour readColour(const JsonFields& fields, std::string_view key, const Colour& usual)
{
    std::array<double, 3> channels{usual.red, usual.green, usual.blue};
    fields.readThree(key, channels);
    const auto clamped = [](double channel) { return static_cast<float>(std::clamp(channel, 0.0, 1.0)); };
    return {clamped(channels[0]), clamped(channels[1]), clamped(channels[2])};
}

JsonValue toJson(const TransferFunction& transfer)
{
    auto json = parseJson(transferFunctionToText(transfer));
    return json ? withOwnNumbers(*std::move(json)) : JsonObject(); // with numbers that are none it is no function
}

void readTransfer(const JsonFields& fields, TransferFunction& transfer)
{
    const JsonValue* const found = fields.find("transfer");
    if (found == nullptr)
        return;
    if (auto read = transferFunctionFromJson(*found))
        transfer = *std::move(read);
    else
        fields.refuse(read.error());
}

JsonValue toJson(const std::vector<Isovalue>& isovalues)
{
    JsonArray list;
    for (const Isovalue& isovalue : isovalues)
        list.push_back(JsonObject{{"value", isovalue.value},
                                  {"colour", toJson(Colour{isovalue.red, isovalue.green, isovalue.blue})},
                                  {"opacity", isovalue.opacity},
                                  {"visible", isovalue.visible}});
    return list;
}

void readIsovalues(const JsonFields& fields, std::vector<Isovalue>& isovalues)
{
    if (fields.has("isovalues"))
        isovalues.clear();
    for (const JsonFields& one : fields.list("isovalues")) {
        Isovalue isovalue;
        one.read("value", isovalue.value);
        const Colour colour = readColour(one, "colour", {isovalue.red, isovalue.green, isovalue.blue});
        isovalue.red = colour.red;
        isovalue.green = colour.green;
        isovalue.blue = colour.blue;
        one.read("opacity", isovalue.opacity);
        one.read("visible", isovalue.visible);
        isovalues.push_back(isovalue);
    }
}

JsonValue toJson(const Appearance& appearance)
{
    JsonObject settings;
    for (const auto& [id, value] : appearance.settings)
        settings.append(id, settingToJson(value));
    return JsonObject{
        {"mode", appearance.mode}, {"transfer", toJson(appearance.transfer)}, {"settings", std::move(settings)}};
}

void readAppearance(const JsonFields& fields, Appearance& appearance)
{
    fields.read("mode", appearance.mode);
    readTransfer(fields, appearance.transfer);
    const JsonFields settings = fields.fields("settings");
    if (settings.members() == nullptr)
        return;
    for (const auto& [id, written] : *settings.members())
        if (auto value = settingOf(written))
            appearance.settings[id] = *std::move(value);
}

} // namespace tetra
