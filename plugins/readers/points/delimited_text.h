// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The lines of a text that hold something, ended by LF, CR LF or CR. Blank lines and comments, which begin with # or
/// % or //, are passed over. Views into the text.
class TextLines {
public:
    explicit TextLines(std::string_view text);

    /// False at the end.
    bool next(std::string_view& line);
    std::uint64_t number() const noexcept { return number_; } ///< of the line that next() gave, from 1
    std::size_t position() const noexcept { return position_; }
    /// The last comment that was passed over since the line before, without its mark; empty if there was none.
    std::string_view comment() const noexcept { return comment_; }

private:
    std::string_view text_;
    std::string_view comment_;
    std::size_t position_ = 0;
    std::uint64_t number_ = 0;
};

std::string_view withoutBlanks(std::string_view text);

/// What separates the fields of a line: a tab, a semicolon, a comma, or else blanks.
char separatorOf(std::string_view line);

/// Splits a line into fields, without the blanks and the double quotes around them; separators in quotes are part of
/// the field. False if a quote is not closed, or something stands between it and the next separator.
bool splitFields(std::string_view line, char separator, std::vector<std::string_view>& fields);

} // namespace tetra
