// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

/// 'A' to 'Z' as small letters, all else as it is: in every locale the same.
constexpr char smallLetter(char c) noexcept
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
inline std::string smallLetters(std::string_view text)
{
    std::string small(text);
    std::ranges::transform(small, small.begin(), smallLetter);
    return small;
}

/// The bytes at the front of `text` that are UTF-8 (RFC 3629); all of them, if the text is.
TAN_INTERNAL std::size_t utf8Bytes(std::string_view text) noexcept;

/// The character at the front of a text.
struct TextCharacter {
    std::uint32_t code = 0xfffd; ///< what stands for a byte that is no UTF-8
    std::size_t bytes = 1;
};
/// `text` is not empty.
TAN_INTERNAL TextCharacter firstCharacter(std::string_view text) noexcept;

/// Whether a character is seen as itself; visibleText() replaces others.
bool isSeenAsItself(std::uint32_t code) noexcept;

/// With how many significant digits a factor is told: three, 1.26, or so many that it differs from 1 in two, 1.0023; at
/// most twelve.
inline int factorDigits(double factor)
{
    constexpr double fewest = 3, most = 12;
    const double wanted = factor > 1 ? 2 - std::floor(std::log10(factor - 1)) : fewest;
    return static_cast<int>(std::clamp(wanted, fewest, most));
}

/// visibleText() of a text of several lines: line feeds stay.
inline std::string visibleLines(std::string_view text)
{
    std::string visible;
    for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
        visible += visibleText(std::string(text.substr(0, end))) + '\n';
        text.remove_prefix(end + 1);
    }
    return visible + visibleText(std::string(text));
}

} // namespace tetra
