// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/base/shown_text.h"
#include "core/transfer/paraview/colour_space_name.h"
#include "core/transfer/paraview/preset_text.h"

#include <pugixml.hpp>

#include <algorithm>

namespace tetra {
namespace {

Error wrongXml(const std::string& what)
{
    return {ErrorKind::BadInput, "The ParaView preset cannot be read: " + what + "."};
}

/// The number of an attribute; `absent` if there is none.
Result<double> numberOf(const pugi::xml_node& point, const char* name, std::optional<double> absent)
{
    const pugi::xml_attribute attribute = point.attribute(name);
    if (!attribute && absent)
        return *absent;
    const auto number = parseNumber<double>(attribute.value());
    if (!number)
        return wrongXml("a point's attribute '" + std::string(name) + "' is '" + attribute.value() + "' and no number");
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
        return wrongXml("the name of a colour map is not UTF-8");
    const std::string space = element.attribute("space").as_string("RGB");
    const auto known = colourSpaceNamed(space, false);
    if (!known)
        return wrongXml("the colour space '" + space + "' of '" + preset.name + "' is not known here");
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
        return wrongXml("the XML is damaged at byte " + std::to_string(parsed.offset) + ": " + parsed.description());
    std::vector<CurvePreset> presets;
    for (const pugi::xpath_node& found : document.select_nodes("//ColorMap")) {
        Result<CurvePreset> preset = presetOf(found.node());
        if (!preset)
            return preset.error();
        presets.push_back(std::move(*preset));
    }
    if (presets.empty())
        return wrongXml("there is no ColorMap element in it");
    return presets;
}

} // namespace tetra
