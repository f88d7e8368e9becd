// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"

#include <algorithm>
#include <array>

namespace tetra {

namespace {

template <class Number> std::string shortest(Number number)
{
    std::array<char, 32> text{}; // -1.7976931348623157e+308 has 24 characters
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
    return {text.data(), end};
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
    const auto byte = [&](std::size_t place) -> unsigned {
        return place < text.size() ? static_cast<unsigned char>(text[place]) : 0;
    };
    std::size_t place = 0;
    while (place < text.size()) {
        const unsigned first = byte(place);
        const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
        // Bounds of the second byte leave out longer forms than needed, halves of surrogate pairs and what would come
        // after the last character.
        const unsigned least = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
        const unsigned largest = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
        if (length > 1 && (first < 0xc2 || first > 0xf4 || byte(place + 1) < least || byte(place + 1) > largest))
            return place;
        for (std::size_t next = place + 2; next < place + length; ++next)
            if ((byte(next) & 0xc0) != 0x80)
                return place;
        place += length;
    }
    return place;
}

std::string printable(std::string_view text)
{
    constexpr std::size_t longest = 80;
    constexpr char deleted = 127;
    std::size_t end = std::min(text.size(), longest);
    while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80)
        --end;
    std::string shown(text.substr(0, end));
    std::ranges::replace_if(
        shown, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == deleted; }, '?');
    for (std::size_t at = utf8Bytes(shown); at < shown.size(); at += utf8Bytes(std::string_view(shown).substr(at)))
        shown[at] = '?';
    return end < text.size() ? shown + "..." : shown;
}

} // namespace tetra
