// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/tools/ruler/ruler_tool.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

namespace tetra {
namespace {

constexpr std::size_t mostPlaces = 3;
constexpr int digits = 5; ///< of what was measured

/// What stands before the next separator, which is taken away with it.
std::string_view nextPart(std::string_view& text, char separator)
{
    const std::string_view part = text.substr(0, text.find(separator));
    text.remove_prefix(std::min(part.size() + 1, text.size()));
    return part;
}

std::optional<Eigen::Vector3d> placeFromText(std::string_view text)
{
    Eigen::Vector3d place;
    for (double& coordinate : place) {
        const auto number = parseNumber<double>(nextPart(text, ','));
        if (!number || !std::isfinite(*number))
            return std::nullopt;
        coordinate = *number;
    }
    return text.empty() ? std::optional(place) : std::nullopt;
}

std::optional<Ruler> rulerFromText(std::string_view text)
{
    Ruler ruler;
    while (!text.empty()) {
        const std::string_view part = nextPart(text, ' ');
        if (part.empty())
            continue;
        const auto place = placeFromText(part);
        if (!place || ruler.size() == mostPlaces)
            return std::nullopt;
        ruler.push_back(*place);
    }
    return ruler.empty() ? std::nullopt : std::optional(ruler);
}

std::string written(double number, const ToolSurroundings& surroundings)
{
    if (surroundings.number)
        return surroundings.number(number, digits);
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

Message lengthText(double length, const ToolSurroundings& surroundings)
{
    const std::string& unit = surroundings.model.lengthUnit;
    const std::string number = written(length, surroundings);
    return unit.empty() ? Message::say("%1 units of the file", number) : Message::say("%1 %2", number, unit);
}

Message angleText(const Ruler& ruler, const ToolSurroundings& surroundings)
{
    return Message::say("%1°", written(angleOf(ruler), surroundings));
}

std::string handleId(std::size_t ruler, std::size_t place)
{
    return std::to_string(ruler) + "." + std::to_string(place);
}

struct PlaceNumber {
    std::size_t ruler = 0;
    std::size_t place = 0;
};

/// Of a handle; nothing if there is no such place.
std::optional<PlaceNumber> numberOf(std::string_view handle, const Rulers& rulers)
{
    const std::string_view first = nextPart(handle, '.');
    const auto ruler = parseNumber<std::size_t>(first), place = parseNumber<std::size_t>(handle);
    if (!ruler || !place || *ruler >= rulers.all.size() || *place >= rulers.all[*ruler].size())
        return std::nullopt;
    return PlaceNumber{*ruler, *place};
}

bool takesAnother(const Rulers& rulers)
{
    return !rulers.all.empty() && !rulers.complete && rulers.all.back().size() < mostPlaces;
}

} // namespace

Rulers rulersFromText(std::string_view text)
{
    Rulers rulers;
    rulers.complete = text.ends_with(';');
    while (!text.empty())
        if (auto ruler = rulerFromText(nextPart(text, ';')))
            rulers.all.push_back(*std::move(ruler));
    return rulers;
}

std::string rulersToText(const Rulers& rulers)
{
    std::string text;
    for (const Ruler& ruler : rulers.all) {
        text += text.empty() ? "" : ";";
        for (std::size_t i = 0; i < ruler.size(); ++i)
            text += (i == 0 ? "" : " ") + formatNumber(ruler[i].x()) + "," + formatNumber(ruler[i].y()) + "," +
                    formatNumber(ruler[i].z());
    }
    return text + (rulers.complete && !rulers.all.empty() ? ";" : "");
}

/// By the tangent of the half: the cosine says little of small angles.
double angleOf(const Ruler& ruler)
{
    const Eigen::Vector3d one = (ruler[0] - ruler[1]).normalized(), other = (ruler[2] - ruler[1]).normalized();
    if (one.isZero() || other.isZero())
        return 0;
    return 2 * std::atan2((one - other).norm(), (one + other).norm()) * 180 / std::numbers::pi;
}

ToolLook RulerTool::look() const
{
    return {.shortcut = "M",
            .icon = {{{4, 16}, {16, 4}, {20, 8}, {8, 20}, {4, 16}},
                     {{7, 13}, {9, 15}},
                     {{10, 10}, {13, 13}},
                     {{13, 7}, {15, 9}}}};
}

ToolDrawing RulerTool::drawing(const ToolSurroundings& surroundings) const
{
    ToolDrawing drawing;
    const Rulers rulers = rulersFromText(surroundings.value);
    for (std::size_t i = 0; i < rulers.all.size(); ++i) {
        const Ruler& ruler = rulers.all[i];
        drawing.lines.push_back({.points = ruler});
        for (std::size_t j = 0; j < ruler.size(); ++j) {
            drawing.points.push_back({.place = ruler[j]});
            drawing.handles.push_back({.id = handleId(i, j),
                                       .place = ruler[j],
                                       .name = Message::say("Place %1 of ruler %2", j + 1, i + 1),
                                       .seeks = true});
            if (j > 0)
                drawing.texts.push_back(
                    {(ruler[j - 1] + ruler[j]) / 2, lengthText((ruler[j] - ruler[j - 1]).norm(), surroundings)});
        }
        if (ruler.size() == mostPlaces)
            drawing.texts.push_back({ruler[1], angleText(ruler, surroundings)});
    }
    return drawing;
}

ToolAnswer RulerTool::clicked(const ToolSurroundings& surroundings, const ToolPointer& pointer) const
{
    Rulers rulers = rulersFromText(surroundings.value);
    if (!takesAnother(rulers))
        rulers.all.emplace_back();
    rulers.complete = false;
    Ruler& ruler = rulers.all.back();
    if (!ruler.empty() && ruler.back() == pointer.place)
        return {}; // clicked twice
    ruler.push_back(pointer.place);
    return {.value = rulersToText(rulers),
            .name = ruler.size() < mostPlaces ? Message::marked("Measure Distance") : Message::marked("Measure Angle")};
}

ToolAnswer RulerTool::moved(const ToolSurroundings& surroundings, const HandleMove& move) const
{
    Rulers rulers = rulersFromText(surroundings.value);
    const auto number = numberOf(move.handle, rulers);
    if (!number)
        return {};
    rulers.all[number->ruler][number->place] = move.pointer.seen ? move.pointer.seen->place : move.to;
    return {.value = rulersToText(rulers), .name = Message::marked("Move Ruler")};
}

std::vector<ToolReading> RulerTool::readings(const ToolSurroundings& surroundings) const
{
    std::vector<ToolReading> readings;
    const Rulers rulers = rulersFromText(surroundings.value);
    for (std::size_t i = 0; i < rulers.all.size(); ++i) {
        const Ruler& ruler = rulers.all[i];
        const auto length = [&](std::size_t from) {
            return lengthText((ruler[from + 1] - ruler[from]).norm(), surroundings);
        };
        if (ruler.size() == 2)
            readings.push_back({Message::say("Ruler %1", i + 1), length(0)});
        else if (ruler.size() == mostPlaces)
            readings.push_back(
                {Message::say("Ruler %1", i + 1),
                 Message::say("%1 and %2, %3 between them", length(0), length(1), angleText(ruler, surroundings))});
    }
    return readings;
}

std::vector<ToolCommand> RulerTool::commands(const ToolSurroundings& surroundings) const
{
    const Rulers rulers = rulersFromText(surroundings.value);
    return {{.id = "new",
             .text = Message::marked("New Ruler"),
             .explanation = Message::marked("Begin another ruler at the next click, without an angle"),
             .key = "N",
             .enabled = takesAnother(rulers) && rulers.all.back().size() == 2},
            {.id = "remove",
             .text = Message::marked("Remove Ruler"),
             .explanation = Message::marked("Remove the selected ruler, or else the last one"),
             .key = "Delete",
             .enabled = !rulers.all.empty()},
            {.id = "clear",
             .text = Message::marked("Remove All Rulers"),
             .explanation = Message::marked("Remove all rulers from the picture"),
             .enabled = !rulers.all.empty()}};
}

ToolAnswer RulerTool::commanded(const ToolSurroundings& surroundings, const std::string& id) const
{
    Rulers rulers = rulersFromText(surroundings.value);
    if (id == "clear")
        return {.value = std::string(), .name = Message::marked("Remove Rulers")};
    if (rulers.all.empty())
        return {};
    if (id == "new") {
        rulers.complete = true;
        return {.value = rulersToText(rulers), .name = Message::marked("Complete Ruler")};
    }
    const auto selected = numberOf(surroundings.handle, rulers);
    const std::size_t removed = selected ? selected->ruler : rulers.all.size() - 1;
    rulers.complete = rulers.complete || removed + 1 == rulers.all.size(); // those before it were complete
    rulers.all.erase(rulers.all.begin() + static_cast<std::ptrdiff_t>(removed));
    return {.value = rulersToText(rulers), .name = Message::marked("Remove Ruler"), .handle = std::string()};
}

} // namespace tetra
