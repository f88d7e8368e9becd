// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/points/table_front.h"

#include "plugins/readers/points/column_names.h"
#include "plugins/readers/points/small_letters.h"
#include "plugins/readers/points/units.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace tetra {

namespace {

using Fields = std::vector<std::string_view>;

bool isNumber(std::string_view field)
{
    return parseNumber<double>(field).has_value();
}

bool isEmpty(std::string_view field)
{
    return field.empty();
}

std::string withoutDoubledQuotes(std::string_view field)
{
    std::string text;
    for (std::size_t i = 0; i < field.size(); ++i) {
        text += field[i];
        if (field[i] == '"' && i + 1 < field.size() && field[i + 1] == '"')
            ++i;
    }
    return text;
}

std::vector<std::string> textsOf(const Fields& fields)
{
    std::vector<std::string> texts;
    for (const std::string_view field : fields)
        texts.push_back(withoutDoubledQuotes(field));
    return texts;
}

/// pandas counts the columns of data that have no names: ",0,1,2,3".
bool isNumbering(const Fields& fields)
{
    for (std::size_t column = 1; column < fields.size(); ++column)
        if (parseNumber<std::size_t>(fields[column]) != column - 1)
            return false;
    return fields.size() > 1 && fields[0].empty();
}

/// A line of names has no number at all where data have four; where it has, as a year, it names the places.
bool isNames(const Fields& fields)
{
    if (std::ranges::all_of(fields, isEmpty))
        return false;
    if (std::ranges::none_of(fields, isNumber) || isNumbering(fields))
        return true;
    std::vector<ColumnName> names;
    for (const std::string_view field : fields)
        names.push_back(parseColumnName(field));
    return findPlaces(names).has_value();
}

/// Without the brackets around it.
std::string_view plainUnit(std::string_view unit)
{
    const bool isBracketed =
        unit.size() > 1 && ((unit.front() == '[' && unit.back() == ']') || (unit.front() == '(' && unit.back() == ')'));
    return isBracketed ? withoutBlanks(unit.substr(1, unit.size() - 2)) : unit;
}

/// Three of them are units of places; the others may be of anything.
bool isUnits(const Fields& fields)
{
    const auto ofPlaces = std::ranges::count_if(
        fields, [](std::string_view field) { return isLengthUnit(plainUnit(field)) || isAngleUnit(plainUnit(field)); });
    return std::ranges::none_of(fields, isNumber) && ofPlaces >= 3;
}

/// Names between blanks may have blanks themselves: "X (m)  T (K)" or, two blanks or more apart, "Mach number". Fields
/// of quotes stay as they are.
Fields joinedFields(std::string_view line, bool atBrackets)
{
    Fields fields;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t begin = std::min(line.find_first_not_of(" \t", at), line.size());
        std::size_t end = begin;
        for (int depth = 0; end < line.size(); ++end) {
            const std::string_view rest = line.substr(end);
            const bool isBlank = rest[0] == ' ' || rest[0] == '\t';
            const std::size_t word = isBlank ? std::min(rest.find_first_not_of(" \t"), rest.size()) : 0;
            depth += rest[0] == '(' || rest[0] == '[' ? 1 : rest[0] == ')' || rest[0] == ']' ? -1 : 0;
            const bool goesOn = atBrackets
                                    ? depth > 0 || (word < rest.size() && (rest[word] == '(' || rest[word] == '['))
                                    : word == 1 && rest[0] == ' ';
            if (isBlank && !goesOn)
                break;
        }
        if (end > begin)
            fields.push_back(withoutBlanks(line.substr(begin, end - begin)));
        at = std::max(end, at + 1);
    }
    return fields;
}

/// The names of a line for so many columns; nothing if it has not so many.
std::optional<std::vector<std::string>> namesOf(std::string_view line, bool isComment, const Fields& row)
{
    const std::size_t columns = row.size();
    std::vector<Fields> ways;
    if (Fields fields; splitFields(line, separatorOf(line), fields))
        ways.push_back(std::move(fields));
    if (Fields fields; splitFields(line, ' ', fields))
        ways.push_back(std::move(fields));
    ways.push_back(joinedFields(line, true));
    ways.push_back(joinedFields(line, false));
    for (Fields& fields : ways)
        if (fields.size() == columns)
            return textsOf(fields);
    for (Fields& fields : ways) {
        const bool hasMore = fields.size() == columns + 1 && fields.back().empty();
        const bool rowHasMore = columns == fields.size() + 1 && row.back().empty();
        // R names no column for the names of its rows.
        const bool rowIsNamed = !isComment && columns == fields.size() + 1 && fields.size() >= 4;
        if (hasMore)
            fields.pop_back();
        else if (!rowHasMore && rowIsNamed)
            fields.insert(fields.begin(), std::string_view());
        if (hasMore || rowHasMore || rowIsNamed)
            return textsOf(fields);
    }
    return {};
}

bool isSection(std::string_view line)
{
    return line.size() > 2 && line.front() == '[' && line.back() == ']' && line.find_first_of("],") == line.size() - 1;
}

bool isDataSection(std::string_view line)
{
    return inSmallLetters(withoutBlanks(line.substr(1, line.size() - 2))) == "data";
}

Error openQuote(std::uint64_t line)
{
    return {ErrorKind::BadInput,
            Message::say("%1 has a double quote that is not closed.", Message::say("line %1", line))};
}

/// Names and what they mean take some hundred bytes a column, in several readings of one line.
constexpr std::size_t mostColumns = 65'536, longestLine = std::size_t(16) << 20;

/// A table is as wide as its first lines: names, units, a row.
Result<void> checkWidth(TextLines lines)
{
    std::string_view line;
    Fields fields;
    for (int count = 0; count < 3 && lines.next(line); ++count) {
        const Message where = Message::say("line %1", lines.number());
        if (std::max(line.size(), lines.comment().size()) > longestLine)
            return Error{
                ErrorKind::BadInput,
                Message::say("%1 or a comment before it is longer than %2 bytes, so this is not a table of points.",
                             where, longestLine)};
        if (splitFields(line, separatorOf(line), fields) && fields.size() > mostColumns)
            return Error{ErrorKind::BadInput,
                         Message::say("%1 has %2 columns, and at most %3 are read. Write a file with only the columns "
                                      "of positions and values that you need.",
                                      where, fields.size(), mostColumns)};
    }
    return {};
}

/// GSLIB: a title, the number of columns, their names one a line, and the rows.
std::optional<TableFront> gslibFront(TextLines lines)
{
    constexpr std::uint64_t least = 4, most = 1000;
    std::string_view line;
    Fields fields;
    if (!lines.next(line))
        return {};
    auto count = parseNumber<std::uint64_t>(line);
    if (!count || lines.comment().empty()) // a title that begins with # is a comment
        if (!lines.next(line))
            return {};
    count = parseNumber<std::uint64_t>(line.substr(0, line.find_first_of(" \t")));
    if (!count || *count < least || *count > most)
        return {};
    TableFront front{.names = {}, .columns = *count, .separator = ' ', .lines = lines};
    while (front.names.size() < *count) {
        if (!front.lines.next(line) || !splitFields(line, separatorOf(line), fields) ||
            std::ranges::all_of(fields, isNumber))
            return {};
        front.names.emplace_back(line);
    }
    TextLines rows = front.lines;
    if (!rows.next(line) || !splitFields(line, front.separator = separatorOf(line), fields) ||
        fields.size() != *count || !isNumber(fields[0]))
        return {};
    return front;
}

/// Leica: the number of points, and their rows.
std::optional<TableFront> countedFront(TextLines lines)
{
    std::string_view line;
    Fields first, second;
    const auto isRow = [&](Fields& fields) {
        return splitFields(line, separatorOf(line), fields) && fields.size() >= 4 &&
               std::ranges::all_of(fields, isNumber);
    };
    const auto count = lines.next(line) ? parseNumber<std::uint64_t>(line) : std::nullopt;
    TableFront front{.form = TableForm::Counted, .names = {}, .lines = lines, .count = count.value_or(0)};
    if (front.count == 0 || !lines.next(line) || !isRow(first))
        return {};
    front.separator = separatorOf(line);
    front.columns = first.size();
    if (front.count > 1 && lines.next(line) && isRow(second) && second.size() != first.size())
        return {};
    return front;
}

/// "% Length unit: m"
std::string comsolLengthUnit(std::string_view comments)
{
    constexpr std::string_view key = "Length unit:";
    const std::size_t at = comments.find(key);
    if (at == std::string_view::npos)
        return {};
    const std::string_view rest = comments.substr(at + key.size());
    return std::string(withoutBlanks(rest.substr(0, rest.find_first_of("\r\n"))));
}

/// Gives each column its unit. A column that counts has none, and a line between blanks no place for one that is empty.
void placeUnits(TableFront& front)
{
    if (front.units.size() == front.columns + 1 && front.units.back().empty())
        front.units.pop_back();
    if (!front.names.empty() && front.units.size() + 1 == front.columns &&
        kindOf(parseColumnName(front.names[0])) == ColumnKind::Counter)
        front.units.insert(front.units.begin(), std::string());
    if (front.units.size() == front.columns)
        return;
    front.unusedUnits = front.units.size();
    front.units.clear();
}

/// Names, if there are any, units, if there are any. `lines` gives the line next that may be the names.
Result<TableFront> plainFront(std::string_view text, TextLines lines)
{
    TextLines before = lines;
    std::string_view line, namesLine;
    Fields fields, row;
    if (!lines.next(line))
        return Error{ErrorKind::BadInput, Message::say("it holds no points.")};
    const auto split = [&](Fields& into) { return splitFields(line, separatorOf(line), into); };
    if (!split(fields))
        return openQuote(lines.number());
    TableFront front{.names = {}, .columns = fields.size(), .separator = separatorOf(line), .lines = before};
    row = fields;
    bool hasRow = true;
    if (isNames(fields)) {
        namesLine = isNumbering(fields) ? std::string_view() : line;
        front.names = isNumbering(fields) ? std::vector<std::string>() : textsOf(fields);
        before = lines;
        hasRow = lines.next(line) && split(row);
        if (hasRow && isUnits(row)) {
            const Fields units = row;
            TextLines behind = lines;
            hasRow = lines.next(line) && split(row);
            before = behind;
            for (const std::string_view unit : units)
                front.units.emplace_back(plainUnit(unit));
        }
    } else if (!lines.comment().empty()) {
        if (Fields words; splitFields(lines.comment(), separatorOf(lines.comment()), words) && isNames(words))
            namesLine = lines.comment();
        front.namesAreComment = !namesLine.empty();
    }
    front.lines = before;
    if (!hasRow)
        return front;
    // A text of a row may hold what separates others.
    if (Fields alike; splitFields(line, front.separator, alike) && alike.size() == fields.size())
        row = alike;
    else
        front.separator = separatorOf(line);
    if (const auto names = namesLine.empty() ? std::nullopt : namesOf(namesLine, front.namesAreComment, row))
        front.names = *names;
    front.columns = front.names.empty() ? row.size() : front.names.size();
    placeUnits(front);
    front.lengthUnit = comsolLengthUnit(text.substr(0, lines.position()));
    return front;
}

} // namespace

Result<TableFront> readTableFront(std::string_view text)
{
    if (const auto checked = checkWidth(TextLines(text)); !checked.ok())
        return checked.error();
    if (auto front = gslibFront(TextLines(text)))
        return *std::move(front);
    if (auto front = countedFront(TextLines(text)))
        return *std::move(front);
    TextLines lines(text);
    TextLines beforeFirst = lines;
    std::string_view line;
    const bool hasSections = lines.next(line) && isSection(line);
    while (hasSections && !isDataSection(line))
        do
            if (!lines.next(line))
                return Error{ErrorKind::BadInput, Message::say("it has no section '[Data]', and so no points.")};
        while (!isSection(line));
    auto front = plainFront(text, hasSections ? lines : beforeFirst);
    if (front && hasSections)
        front->form = TableForm::Sections;
    return front;
}

bool hasSpecialForm(std::string_view beginning)
{
    const auto front = readTableFront(beginning);
    return gslibFront(TextLines(beginning)) || (front && front->form != TableForm::Plain);
}

TableRows::TableRows(const TableFront& front)
    : form_(front.form), columns_(front.columns), separator_(front.separator), lines_(front.lines),
      countLine_(front.lines.number()), count_(front.count)
{
}

Result<bool> TableRows::next(std::vector<std::string_view>& fields)
{
    std::string_view line;
    for (;;) {
        fields.clear();
        if (!lines_.next(line))
            return form_ == TableForm::Counted && rows_ != count_ ? Result<bool>(wrongCount()) : false;
        if (form_ == TableForm::Sections && isSection(line)) {
            if (const auto found = findData(line); !found.ok() || !*found)
                return found;
        } else if (const auto count = parseNumber<std::uint64_t>(line); form_ == TableForm::Counted && count) {
            if (rows_ != count_)
                return wrongCount();
            countLine_ = lines_.number();
            count_ = *count;
            rows_ = 0;
            ++parts_;
        } else {
            break;
        }
    }
    if (!splitFields(line, separator_, fields))
        return openQuote(lines_.number());
    if (fields.size() == columns_ + 1 && fields.back().empty())
        fields.pop_back();
    if (form_ == TableForm::Counted && rows_++ == count_)
        return wrongCount();
    return true;
}

Result<bool> TableRows::findData(std::string_view line)
{
    while (!isDataSection(line)) {
        const std::string name(line);
        std::uint64_t content = 0;
        bool more = false;
        for (more = lines_.next(line); more && !isSection(line); more = lines_.next(line))
            ++content;
        if (content > 1 && std::ranges::find(otherSections_, name) == otherSections_.end())
            otherSections_.push_back(name);
        if (!more)
            return false;
    }
    std::vector<std::string_view> names;
    if (!lines_.next(line))
        return false;
    if (!splitFields(line, separator_, names) || names.size() != columns_)
        return Error{ErrorKind::BadInput,
                     Message::say("%1 has %2 columns, and the lines before have %3.",
                                  Message::say("line %1", lines_.number()), names.size(), columns_)};
    ++parts_;
    return true;
}

Error TableRows::wrongCount() const
{
    return rows_ > count_ ? Error{ErrorKind::BadInput,
                                  Message::say("line %1 announces %2 points, and there are more.", countLine_, count_)}
                          : Error{ErrorKind::BadInput, Message::say("line %1 announces %2 points, and there are %3. "
                                                                    "The copy may be incomplete: copy the file again.",
                                                                    countLine_, count_, rows_)};
}

} // namespace tetra
