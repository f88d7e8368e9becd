// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace tetra {

/// Numbers in files and options, the same under every locale: a decimal point, no grouping.

/// All of `text` as a Number: decimal, one leading '+' allowed. Nothing if anything else stands in it (blanks too) or
/// the number does not fit. Floating-point types know exponents, "inf" and "nan".
template <class Number>
requires std::integral<Number> || std::floating_point<Number> std::optional<Number> parseNumber(std::string_view text)
{
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size())
        return {};
    return number;
}

/// The shortest text that parseNumber() turns into the same number again.
TAN_INTERNAL std::string formatNumber(double number);
TAN_INTERNAL std::string formatNumber(float number);

/// What a piece of work needs of memory or of a disk, for messages: "12 MB", "1.3 GB", rounded up.
inline std::string neededBytesText(std::uint64_t bytes)
{
    const auto size = static_cast<double>(bytes);
    return bytes < 1'000'000'000 ? formatNumber(std::ceil(size / 1e6)) + " MB"
                                 : formatNumber(std::ceil(size / 1e8) / 10) + " GB";
}

/// A piece of somebody's file or option for a message: at most 80 bytes and no half character; what controls a
/// terminal, and what is no UTF-8, is replaced by '?'.
TAN_INTERNAL std::string printable(std::string_view text);

/// The bytes at the front of `text` that are UTF-8 (RFC 3629); all of them, if the text is.
std::size_t utf8Bytes(std::string_view text) noexcept;

/// The name's ending with its dot, in small letters.
inline std::string fileEnding(const std::filesystem::path& path)
{
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

} // namespace tetra
