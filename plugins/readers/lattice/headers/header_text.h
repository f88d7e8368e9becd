// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// Small helpers for the text of headers and parameters; ASCII only, no locale.

/// Without blanks, tabs and line ends at both ends.
std::string_view trimmed(std::string_view text);

std::string lowerCase(std::string_view text);

/// The parts between any of `separators`, without empty ones.
std::vector<std::string_view> split(std::string_view text, std::string_view separators);

/// A file as a text.
inline std::string_view asText(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A number as headers and texts of other programs have it: also with the exponents of Fortran, 1.5D+03 and 1.5+103.
std::optional<double> parseHeaderNumber(std::string_view word);

/// The lines that a file begins with, one after the other.
class HeaderLines {
public:
    explicit HeaderLines(std::string_view text) : rest_(text) {}

    /// The next line without its end; none after the last.
    std::optional<std::string_view> next();
    /// Of the line that came last, from 1.
    std::size_t number() const noexcept { return number_; }
    /// What follows it.
    std::string_view rest() const noexcept { return rest_; }

private:
    std::string_view rest_;
    std::size_t number_ = 0;
};

/// Takes the next word off the front of a text; empty at its end.
std::string_view takeHeaderWord(std::string_view& text);

} // namespace tetra
