// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/fluent_nodes.h"

#include <tan/base.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <span>

namespace tetra {
namespace {

constexpr std::string_view fluentBlanks = " \t\r\n";

void skipFluentBlanks(std::string_view& text)
{
    text.remove_prefix(std::min(text.find_first_not_of(fluentBlanks), text.size()));
}

template <class Number, class... How> bool takeFluentNumber(std::string_view& text, Number& number, How... how)
{
    skipFluentBlanks(text);
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number, how...);
    if (read.ec != std::errc())
        return false;
    text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
    return true;
}

bool takeFluentBracket(std::string_view& text, char bracket)
{
    skipFluentBlanks(text);
    if (!text.starts_with(bracket))
        return false;
    text.remove_prefix(1);
    return true;
}

/// What stands at the beginning of a section of nodes: "(10 (1 1 2d5 1 3)(", in hexadecimal.
struct NodeSection {
    std::uint64_t zone = 0, first = 0, last = 0;
    bool isBinary = false;
};

/// Takes one whose numbers follow; false for anything else.
bool takeNodeSection(std::string_view& text, NodeSection& section)
{
    constexpr int hexadecimal = 16;
    int number = 0;
    if (!takeFluentBracket(text, '(') || !takeFluentNumber(text, number) || (number != 10 && number != 3010) ||
        !takeFluentBracket(text, '('))
        return false;
    section.isBinary = number == 3010;
    for (std::uint64_t* part : {&section.zone, &section.first, &section.last})
        if (!takeFluentNumber(text, *part, hexadecimal))
            return false;
    std::uint64_t type = 0, dimensions = 3;
    takeFluentNumber(text, type, hexadecimal);
    takeFluentNumber(text, dimensions, hexadecimal);
    return dimensions == 3 && takeFluentBracket(text, ')') && section.zone > 0 && takeFluentBracket(text, '(');
}

/// Into three numbers each; false if there are fewer.
bool takePlaces(std::string_view& text, bool isBinary, std::span<double> places)
{
    if (isBinary) {
        if (text.size() < places.size_bytes())
            return false;
        std::memcpy(places.data(), text.data(), places.size_bytes());
        text.remove_prefix(places.size_bytes());
        return true;
    }
    return std::ranges::all_of(places, [&](double& number) { return takeFluentNumber(text, number); });
}

} // namespace

std::optional<std::vector<double>> readFluentNodes(std::string_view text, std::uint64_t nodes)
{
    if (nodes > text.size() / 3)
        return std::nullopt;
    std::vector<double> places(3 * nodes);
    std::uint64_t told = 0;
    for (auto bracket = text.find('('); bracket != std::string_view::npos; bracket = text.find('(')) {
        text.remove_prefix(bracket);
        std::string_view rest = text;
        NodeSection section;
        if (!takeNodeSection(rest, section)) {
            text.remove_prefix(1);
            continue;
        }
        text = rest;
        if (section.first < 1 || section.last < section.first || section.last > nodes)
            return std::nullopt;
        const std::uint64_t count = section.last - section.first + 1;
        if (!takePlaces(text, section.isBinary, std::span(places).subspan(3 * (section.first - 1), 3 * count)))
            return std::nullopt;
        told += count;
    }
    return told == nodes ? std::optional(std::move(places)) : std::nullopt;
}

} // namespace tetra
