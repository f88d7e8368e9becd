// SPDX-License-Identifier: GPL-3.0-or-later
#include <plugins/api/plugin.h>
#include <plugins/api/tool.h>

#include <cstdio>
#include <sstream>

namespace {
using namespace tetra;

/// A value of the field, and where it was seen.
struct Note {
    Eigen::Vector3d place{0, 0, 0};
    double value = 0;
};

/// What the tool keeps: four numbers for each note, with blanks between them.
std::vector<Note> notesOf(const std::string& text)
{
    std::istringstream words(text);
    std::vector<double> numbers;
    for (std::string word; words >> word;)
        numbers.push_back(parseNumber<double>(word).value_or(0));
    std::vector<Note> notes;
    for (std::size_t i = 0; i + 4 <= numbers.size(); i += 4)
        notes.push_back({{numbers[i], numbers[i + 1], numbers[i + 2]}, numbers[i + 3]});
    return notes;
}

std::string textOf(const std::vector<Note>& notes)
{
    std::string text;
    for (const auto& [place, value] : notes)
        for (const double number : {place.x(), place.y(), place.z(), value})
            text += formatNumber(number) + " ";
    return text;
}

std::string shown(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}
} // namespace

/// The value beside the pointer, and pinned where one clicks; handles drag the pins.
class NoteTool : public tetra::Tool {
public:
    ToolLook look() const override
    {
        return {.shortcut = "K", .icon = {{{4, 4}, {20, 4}, {20, 15}, {9, 15}, {4, 20}, {4, 4}}}};
    }
    ToolNeeds needs() const override { return {.pointer = true}; }

    ToolDrawing drawing(const ToolSurroundings& now) const override
    {
        ToolDrawing drawing;
        if (now.pointer && now.pointer->seen && now.pointer->seen->value)
            drawing.texts.push_back({now.pointer->place, shown(*now.pointer->seen->value)});
        for (const auto& [place, value] : notesOf(now.value)) {
            drawing.points.push_back({.place = place});
            drawing.texts.push_back({place, shown(value)});
            drawing.handles.push_back({.id = std::to_string(drawing.handles.size()),
                                       .place = place,
                                       .name = Message::say("Note %1", drawing.handles.size() + 1),
                                       .seeks = true});
        }
        return drawing;
    }
    ToolAnswer clicked(const ToolSurroundings& now, const ToolPointer& pointer) const override
    {
        if (!pointer.seen || !pointer.seen->value)
            return {};
        std::vector<Note> notes = notesOf(now.value);
        notes.push_back({pointer.place, *pointer.seen->value});
        return {.value = textOf(notes), .name = Message::marked("Pin Value")};
    }
    ToolAnswer moved(const ToolSurroundings& now, const HandleMove& move) const override
    {
        std::vector<Note> notes = notesOf(now.value);
        const auto number = parseNumber<std::size_t>(move.handle);
        if (!number || *number >= notes.size() || !move.pointer.seen || !move.pointer.seen->value)
            return {};
        notes[*number] = {move.pointer.place, *move.pointer.seen->value};
        return {.value = textOf(notes), .name = Message::marked("Move Value")};
    }
    std::vector<ToolCommand> commands(const ToolSurroundings& now) const override
    {
        return {{"clear", Message::marked("Remove All"), Message::marked("Remove all values from the picture"),
                 "Delete", !now.value.empty()}};
    }
    ToolAnswer commanded(const ToolSurroundings&, const std::string&) const override { return {.value = ""}; }
};

TAN_PLUGIN(NoteTool, tetra::Tool)
