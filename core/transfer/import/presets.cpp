// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/import/presets.h"

#include "core/base/json_writer.h"
#include "core/base/text.h"
#include "core/transfer/colour_map.h"

#include <tan/transfer.h>

#include <pugixml.hpp>

#include <algorithm>
#include <cstddef>

namespace tetra {

namespace {

Error wrongJson(const JsonValue& value, const Message& what)
{
    return {ErrorKind::BadInput,
            Message::say("The ParaView preset cannot be read: %1 (%2).", what, describePlace(value.place))};
}

/// The numbers of a list whose length is a multiple of `stride`; nothing for null, as ParaView writes for none.
Result<std::vector<double>> numbersOf(const JsonValue* value, std::string_view name, std::size_t stride)
{
    std::vector<double> numbers;
    if (value == nullptr || std::holds_alternative<std::nullptr_t>(value->content))
        return numbers;
    const JsonArray* array = value->array();
    if (array == nullptr || array->size() % stride != 0)
        return wrongJson(*value, Message::say("\"%1\" must be a list of numbers, %2 for each point", name, stride));
    for (const JsonValue& element : *array) {
        const auto number = element.number() != nullptr ? parseNumber<double>(element.number()->text) : std::nullopt;
        if (!number)
            return wrongJson(element, Message::say("\"%1\" holds something that is not a number", name));
        numbers.push_back(*number);
    }
    return numbers;
}

bool isSet(const JsonValue* value)
{
    if (value == nullptr)
        return false;
    if (const bool* truth = std::get_if<bool>(&value->content))
        return *truth;
    return value->number() != nullptr && parseNumber<double>(value->number()->text).value_or(0) != 0;
}

Status readColours(const JsonValue& object, ColourCurve& curve)
{
    const Result<std::vector<double>> numbers = numbersOf(object.find("RGBPoints"), "RGBPoints", 4);
    if (!numbers)
        return numbers.error();
    for (std::size_t node = 0; node < numbers->size(); node += 4)
        curve.nodes.push_back({(*numbers)[node], {(*numbers)[node + 1], (*numbers)[node + 2], (*numbers)[node + 3]}});
    if (curve.nodes.empty())
        return {};
    const JsonValue* space = object.find("ColorSpace");
    const std::string name = space != nullptr && space->string() != nullptr ? *space->string() : "RGB";
    const auto known = colourSpaceNamed(name, isSet(object.find("HSVWrap")));
    if (!known)
        return wrongJson(
            *space,
            Message::say("the colour space '%1' is not known here; choose another one in ParaView's colour map editor",
                         name));
    curve.space = *known;
    curve.logarithmic = isSet(object.find("UseLogScale"));
    return {};
}

Status readOpacities(const JsonValue& object, std::vector<OpacityNode>& nodes)
{
    const Result<std::vector<double>> numbers = numbersOf(object.find("Points"), "Points", 4);
    if (!numbers)
        return numbers.error();
    for (std::size_t node = 0; node < numbers->size(); node += 4)
        nodes.push_back({(*numbers)[node], (*numbers)[node + 1], (*numbers)[node + 2], (*numbers)[node + 3]});
    return {};
}

Result<CurvePreset> presetOf(const JsonValue& object)
{
    if (object.object() == nullptr)
        return wrongJson(object, Message::say("a preset must be an object, in braces"));
    CurvePreset preset;
    if (const JsonValue* name = object.find("Name"); name != nullptr && name->string() != nullptr)
        preset.name = *name->string();
    if (Status colours = readColours(object, preset.colours); !colours)
        return colours.error();
    if (Status opacities = readOpacities(object, preset.opacities); !opacities)
        return opacities.error();
    if (preset.colours.nodes.empty() && preset.opacities.empty() && object.find("IndexedColors") != nullptr)
        return wrongJson(object,
                         Message::say("'%1' has colours for categories and none for values in between", preset.name));
    if (Status good = checkCurves(preset); !good)
        return good.error();
    return preset;
}

} // namespace

Result<std::vector<CurvePreset>> presetsFromJson(const JsonValue& root)
{
    std::vector<CurvePreset> presets;
    const auto add = [&presets](const JsonValue& object) -> Status {
        Result<CurvePreset> preset = presetOf(object);
        if (!preset)
            return preset.error();
        presets.push_back(std::move(*preset));
        return {};
    };
    if (root.array() == nullptr) {
        if (Status added = add(root); !added)
            return added.error();
        return presets;
    }
    for (const JsonValue& object : *root.array())
        if (Status added = add(object); !added)
            return added.error();
    if (presets.empty())
        return wrongJson(root, Message::say("the list is empty"));
    return presets;
}

std::string presetToJson(const CurvePreset& preset)
{
    std::string colours, opacities;
    const auto add = [](std::string& list, double number) {
        list += (list.empty() ? "" : ", ") + formatNumber(number);
    };
    for (const ColourNode& node : preset.colours.nodes) {
        add(colours, node.value);
        for (const double channel : node.colour)
            add(colours, channel);
    }
    for (const OpacityNode& node : preset.opacities)
        for (const double number : {node.value, node.opacity, node.midpoint, node.sharpness})
            add(opacities, number);
    return "[\n  {\n    \"ColorSpace\": " + jsonString(colourSpaceName(preset.colours.space)) +
           ",\n    \"HSVWrap\": " + (preset.colours.space == ColourSpace::HsvWrapped ? "1" : "0") +
           ",\n    \"UseLogScale\": " + (preset.colours.logarithmic ? "1" : "0") +
           ",\n    \"Name\": " + jsonString(preset.name) + ",\n    \"Points\": [" + opacities +
           "],\n    \"RGBPoints\": [" + colours + "]\n  }\n]\n";
}

namespace {

Error wrongXml(const Message& what)
{
    return {ErrorKind::BadInput, Message::say("The ParaView preset cannot be read: %1.", what)};
}

/// The number of an attribute; `absent` if there is none.
Result<double> numberOf(const pugi::xml_node& point, const char* name, std::optional<double> absent)
{
    const pugi::xml_attribute attribute = point.attribute(name);
    if (!attribute && absent)
        return *absent;
    const auto number = parseNumber<double>(attribute.value());
    if (!number)
        return wrongXml(
            Message::say("a point's attribute '%1' is '%2', which is not a number", name, attribute.value()));
    return *number;
}

Status addPoint(const pugi::xml_node& point, CurvePreset& preset)
{
    double numbers[5] = {};
    const char* const names[5] = {"x", "r", "g", "b", "o"};
    for (std::size_t which = 0; which < 5; ++which) {
        const Result<double> number = numberOf(point, names[which], which == 4 ? std::optional(1.0) : std::nullopt);
        if (!number)
            return number.error();
        numbers[which] = *number;
    }
    preset.colours.nodes.push_back({numbers[0], {numbers[1], numbers[2], numbers[3]}});
    preset.opacities.push_back({numbers[0], numbers[4]});
    return {};
}

Result<CurvePreset> presetOf(const pugi::xml_node& element)
{
    CurvePreset preset;
    preset.name = element.attribute("name").value();
    if (utf8Bytes(preset.name) < preset.name.size())
        return wrongXml(Message::say("the name of a colour map is not UTF-8"));
    const std::string space = element.attribute("space").as_string("RGB");
    const auto known = colourSpaceNamed(space, false);
    if (!known)
        return wrongXml(Message::say("the colour space '%1' of '%2' is not known here", space, preset.name));
    preset.colours.space = *known;
    for (const pugi::xml_node& point : element.children("Point"))
        if (Status added = addPoint(point, preset); !added)
            return added.error();
    if (std::ranges::all_of(preset.opacities, [](const OpacityNode& node) { return node.opacity == 1; }))
        preset.opacities.clear();
    if (Status good = checkCurves(preset); !good)
        return good.error();
    return preset;
}

} // namespace

Result<std::vector<CurvePreset>> presetsFromXml(std::string_view text)
{
    pugi::xml_document document;
    if (const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size()); !parsed)
        return wrongXml(Message::say("the XML is damaged at byte %1: %2", parsed.offset, parsed.description()));
    std::vector<CurvePreset> presets;
    for (const pugi::xpath_node& found : document.select_nodes("//ColorMap")) {
        Result<CurvePreset> preset = presetOf(found.node());
        if (!preset)
            return preset.error();
        presets.push_back(std::move(*preset));
    }
    if (presets.empty())
        return wrongXml(Message::say("there is no ColorMap element in it"));
    return presets;
}

} // namespace tetra
