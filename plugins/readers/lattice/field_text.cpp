// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/field_text.h"

#include <algorithm>

namespace tetra {

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\n\v\f";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string lowerCase(std::string_view text)
{
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return lower;
}

std::vector<std::string_view> split(std::string_view text, std::string_view separators)
{
    std::vector<std::string_view> parts;
    std::size_t first = text.find_first_not_of(separators);
    while (first != std::string_view::npos) {
        const std::size_t end = std::min(text.find_first_of(separators, first), text.size());
        parts.push_back(text.substr(first, end - first));
        first = text.find_first_not_of(separators, end);
    }
    return parts;
}

} // namespace tetra
