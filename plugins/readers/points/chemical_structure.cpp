// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/points/chemical_structure.h"

#include "plugins/readers/points/delimited_text.h"

#include <tan/base.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

namespace {

/// Takes the first line off the text. Unlike TextLines it counts blank lines and comments: the second line may be one.
std::string_view takeLine(std::string_view& text)
{
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    return withoutBlanks(line);
}

/// "C", "Cl", also with the number that some programs add: "C12".
bool isElement(std::string_view field)
{
    constexpr std::size_t longestSymbol = 2;
    const auto isLetter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    const auto symbolEnd = std::ranges::find_if_not(field, isLetter);
    const auto letters = static_cast<std::size_t>(symbolEnd - field.begin());
    return letters >= 1 && letters <= longestSymbol && std::all_of(symbolEnd, field.end(), isDigit);
}

} // namespace

bool isChemicalStructure(std::string_view text)
{
    if (!parseNumber<std::uint64_t>(takeLine(text)))
        return false;
    takeLine(text);
    std::vector<std::string_view> fields;
    return splitFields(takeLine(text), ' ', fields) && fields.size() >= 4 && isElement(fields[0]) &&
           std::ranges::all_of(std::span(fields).subspan(1, 3),
                               [](std::string_view field) { return parseNumber<double>(field).has_value(); });
}

} // namespace tetra
