// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <concepts>
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
std::string formatNumber(double number);
std::string formatNumber(float number);

} // namespace tetra
