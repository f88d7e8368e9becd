// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace tetra {

namespace {

template <class Number> std::string shortest(Number number)
{
    std::array<char, 32> text{}; // -1.7976931348623157e+308 has 24 characters
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
    return {text.data(), end};
}

/// How many bytes a UTF-8 character (RFC 3629) at the front of `text` has; 0 if there is none.
std::size_t characterBytes(std::string_view text) noexcept
{
    const auto byte = [&](std::size_t place) -> unsigned {
        return place < text.size() ? static_cast<unsigned char>(text[place]) : 0;
    };
    if (text.empty())
        return 0;
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    // Bounds of the second byte leave out longer forms than needed, halves of surrogate pairs and what would come
    // after the last character.
    const unsigned least = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
    const unsigned largest = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
    if (length > 1 && (first < 0xc2 || first > 0xf4 || byte(1) < least || byte(1) > largest))
        return 0;
    for (std::size_t next = 2; next < length; ++next)
        if ((byte(next) & 0xc0) != 0x80)
            return 0;
    return length;
}

/// The number of a character of `length` bytes.
std::uint32_t codeOf(std::string_view text, std::size_t length) noexcept
{
    if (length == 1)
        return static_cast<unsigned char>(text[0]);
    std::uint32_t code = static_cast<unsigned char>(text[0]) & (0x7fU >> length);
    for (std::size_t place = 1; place < length; ++place)
        code = code << 6 | (static_cast<unsigned char>(text[place]) & 0x3fU);
    return code;
}

struct CodeRange {
    std::uint32_t first, last;
};

/// Characters that are not seen as themselves (Unicode 15, categories Cc, Zl, Zp and Cf): controls, line breaks, marks
/// of direction and what has no shape, the Hangul fillers among them. Not among them are the joiners U+200C and U+200D,
/// without which several languages cannot be written, and the signs of category Cf that are seen.
constexpr std::array<CodeRange, 20> notSeen = {
    {{0x00, 0x1f},     {0x7f, 0x9f},       {0xad, 0xad},       {0x61c, 0x61c},     {0x70f, 0x70f},
     {0x115f, 0x1160}, {0x180e, 0x180e},   {0x200b, 0x200b},   {0x200e, 0x200f},   {0x2028, 0x202e},
     {0x2060, 0x206f}, {0x3164, 0x3164},   {0xfeff, 0xfeff},   {0xffa0, 0xffa0},   {0xfff0, 0xfffb},
     {0xfffe, 0xffff}, {0x13430, 0x1343f}, {0x1bca0, 0x1bca3}, {0x1d173, 0x1d17a}, {0xe0000, 0xe007f}}};

std::string hexadecimal(std::uint32_t number, std::size_t digits)
{
    std::string text(digits, '0');
    for (std::size_t place = digits; place-- > 0; number >>= 4)
        text[place] = "0123456789abcdef"[number & 15];
    return text;
}

std::string escapeOf(std::uint32_t code)
{
    switch (code) {
    case '\n': return "\\n";
    case '\r': return "\\r";
    case '\t': return "\\t";
    default: break;
    }
    return code < 0x80      ? "\\x" + hexadecimal(code, 2)
           : code <= 0xffff ? "\\u" + hexadecimal(code, 4)
                            : "\\U" + hexadecimal(code, 8);
}

} // namespace

std::string formatNumber(double number)
{
    return shortest(number);
}

std::string formatNumber(float number)
{
    return shortest(number);
}

std::size_t utf8Bytes(std::string_view text) noexcept
{
    std::size_t place = 0;
    while (const std::size_t length = characterBytes(text.substr(place)))
        place += length;
    return place;
}

TextCharacter firstCharacter(std::string_view text) noexcept
{
    const std::size_t length = characterBytes(text);
    return length == 0 ? TextCharacter{} : TextCharacter{codeOf(text, length), length};
}

bool isSeenAsItself(std::uint32_t code) noexcept
{
    return std::ranges::none_of(notSeen,
                                [&](const CodeRange& range) { return range.first <= code && code <= range.last; });
}

std::string visibleText(std::string text)
{
    if (std::ranges::all_of(text, [](char c) { return c >= ' ' && c < 0x7f; }))
        return text;
    std::string shown;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t length = characterBytes(rest);
        if (length == 0)
            shown += "\\x" + hexadecimal(static_cast<unsigned char>(rest[0]), 2);
        else if (const std::uint32_t code = codeOf(rest, length); isSeenAsItself(code))
            shown += rest.substr(0, length);
        else
            shown += escapeOf(code);
        rest.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return shown;
}

std::string printable(std::string_view text)
{
    constexpr std::size_t longest = 80;
    std::size_t end = std::min(text.size(), longest);
    while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80)
        --end;
    std::string shown = visibleText(std::string(text.substr(0, end)));
    return end < text.size() ? shown + "..." : shown;
}

} // namespace tetra
