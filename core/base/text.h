// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

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
std::size_t utf8Bytes(std::string_view text) noexcept;

} // namespace tetra
