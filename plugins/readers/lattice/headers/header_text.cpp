// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/headers/header_text.h"

#include <algorithm>
#include <string>

namespace tetra {

namespace {

/// With the exponent as C has it, where Fortran wrote it; else as it is.
std::string withUsualExponent(std::string_view word)
{
    std::string usual(word);
    if (const auto mark = usual.find_first_of("dD"); mark != std::string::npos)
        usual[mark] = 'e';
    else if (const auto sign = usual.find_first_of("+-", 1);
             sign != std::string::npos && usual.find_first_of("eE") == std::string::npos)
        usual.insert(sign, 1, 'e');
    return usual;
}

} // namespace

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

std::optional<double> parseHeaderNumber(std::string_view word)
{
    if (const auto number = parseNumber<double>(word))
        return number;
    constexpr std::size_t longestNumber = 400; // as of printf("%f")
    if (word.empty() || word.size() > longestNumber)
        return {};
    if (const auto number = parseNumber<double>(withUsualExponent(word)))
        return number;
    // So small that a double keeps nothing of it: from_chars() takes that for an error.
    const std::string usual = withUsualExponent(word);
    const auto exponent = usual.find_first_of("eE");
    if (exponent == std::string::npos || usual.compare(exponent + 1, 1, "-") != 0)
        return {};
    const auto mantissa = parseNumber<double>(std::string_view(usual).substr(0, exponent));
    const std::string_view digits = std::string_view(usual).substr(exponent + 2);
    const bool isNumber = !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
    return mantissa && isNumber ? std::optional(0.0) : std::nullopt;
}

std::optional<std::string_view> HeaderLines::next()
{
    if (rest_.empty())
        return {};
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    ++number_;
    return line;
}

std::string_view takeHeaderWord(std::string_view& text)
{
    constexpr std::string_view blanks = " \t\r\n\v\f";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    return word;
}

} // namespace tetra
