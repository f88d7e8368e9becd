// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/points/delimited_text.h"

#include <algorithm>

namespace tetra {

namespace {

constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

/// How many characters mark the line as a comment.
std::size_t commentMark(std::string_view line)
{
    if (line.starts_with("//"))
        return 2;
    return line.starts_with('#') || line.starts_with('%') ? 1 : 0;
}

} // namespace

TextLines::TextLines(std::string_view text) : text_(text), position_(text.starts_with(byteOrderMark) ? 3 : 0) {}

bool TextLines::next(std::string_view& line)
{
    comment_ = {};
    while (position_ < text_.size()) {
        const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
        line = withoutBlanks(text_.substr(position_, end - position_));
        const bool isPair = end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n';
        position_ = end + (isPair ? 2 : 1);
        ++number_;
        if (line.empty())
            continue;
        const std::size_t mark = commentMark(line);
        if (mark == 0)
            return true;
        comment_ = withoutBlanks(line.substr(mark));
    }
    return false;
}

std::string_view withoutBlanks(std::string_view text)
{
    constexpr std::string_view blanks = " \t";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

char separatorOf(std::string_view line)
{
    bool quoted = false;
    std::string found;
    for (const char character : line) {
        if (character == '"')
            quoted = !quoted;
        else if (!quoted)
            found += character;
    }
    for (const char separator : {'\t', ';', ','})
        if (found.find(separator) != std::string::npos)
            return separator;
    return ' ';
}

bool splitFields(std::string_view line, char separator, std::vector<std::string_view>& fields)
{
    const std::string_view ends = separator == ' ' ? " \t" : std::string_view(&separator, 1);
    fields.clear();
    for (;;) {
        // With tabs for separators, an empty field begins with the tab that ends it.
        while (!line.empty() && line.front() != separator && (line.front() == ' ' || line.front() == '\t'))
            line.remove_prefix(1);
        if (separator == ' ')
            line = withoutBlanks(line);
        std::size_t end = 0;
        if (line.starts_with('"')) {
            std::size_t quote = line.find('"', 1);
            while (quote != std::string_view::npos && quote + 1 < line.size() && line[quote + 1] == '"')
                quote = line.find('"', quote + 2);
            if (quote == std::string_view::npos)
                return false;
            fields.push_back(line.substr(1, quote - 1));
            end = std::min(line.find_first_of(ends, quote + 1), line.size());
            if (!withoutBlanks(line.substr(quote + 1, end - quote - 1)).empty())
                return false;
        } else {
            end = std::min(line.find_first_of(ends), line.size());
            fields.push_back(withoutBlanks(line.substr(0, end)));
        }
        if (end == line.size())
            return true;
        line.remove_prefix(end + 1);
    }
}

} // namespace tetra
