// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/points/point_table.h"

#include "plugins/readers/points/chemical_structure.h"
#include "plugins/readers/points/delimited_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace tetra {

namespace {

/// So large coordinates have no volumes that fit a double, and so small ones none that differ from zero.
constexpr double largestCoordinate = 1e90;

Message lineText(std::uint64_t number)
{
    return Message::say("line %1", number);
}

/// What a message shows of a field.
std::string shown(std::string_view field)
{
    constexpr std::size_t most = 40;
    return "'" + printable(field.substr(0, most)) + (field.size() > most ? "...'" : "'");
}

/// A line of names has no number at all where data have four.
bool isNames(const std::vector<std::string_view>& fields)
{
    return std::ranges::none_of(fields, [](std::string_view field) { return parseNumber<double>(field).has_value(); });
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

/// The names of the columns: those of the file, else their numbers.
std::vector<std::string> namesFor(const std::vector<std::string_view>& names, std::size_t columns)
{
    std::vector<std::string> texts;
    for (std::size_t column = 0; column < columns; ++column)
        texts.push_back(names.empty() ? "column " + std::to_string(column + 1) : withoutDoubledQuotes(names[column]));
    return texts;
}

class TableReading {
public:
    TableReading(std::string_view text, const PointTableRequest& request) : text_(text), request_(request), lines_(text)
    {
    }

    Result<PointTable> run(const Progress& progress);
    Result<PointColumns> readColumns();

private:
    Status readFront();
    Status split(std::string_view line);
    Status addRow();
    Result<double> number(std::size_t column) const; ///< what is written there, also "nan"
    Error notFinite(std::size_t column) const;

    std::string_view text_;
    const PointTableRequest& request_;
    TextLines lines_;
    char separator_ = ',';
    PointColumns columns_;
    std::vector<std::string_view> fields_;
    bool hasRow_ = false; ///< the first row of data is in fields_
    PointTable table_;
};

Status TableReading::split(std::string_view line)
{
    if (!splitFields(line, separator_, fields_))
        return Error{ErrorKind::BadInput,
                     Message::say("%1 has a double quote that is not closed.", lineText(lines_.number()))};
    return {};
}

/// Names, if there are any, and the columns.
Status TableReading::readFront()
{
    std::string_view line;
    if (!lines_.next(line))
        return Error{ErrorKind::BadInput, Message::say("it holds no points.")};
    separator_ = separatorOf(line);
    if (const Status done = split(line); !done)
        return done;
    std::vector<std::string_view> names;
    hasRow_ = !isNames(fields_);
    if (!hasRow_) {
        names = fields_;
    } else if (std::vector<std::string_view> commented; splitFields(lines_.comment(), separator_, commented) &&
                                                        commented.size() == fields_.size() && isNames(commented)) {
        names = commented;
    }
    auto columns = choosePointColumns(namesFor(names, fields_.size()), request_.positions, request_.value);
    if (!columns)
        return columns.error();
    columns_ = std::move(*columns);
    if (!names.empty())
        table_.valueName = columns_.names[columns_.value];
    return {};
}

Result<double> TableReading::number(std::size_t column) const
{
    const std::string_view field = fields_[column];
    if (const auto number = parseNumber<double>(field))
        return *number;
    const Message line = lineText(lines_.number());
    const std::string name = printable(columns_.names[column]);
    if (field.empty())
        return Error{ErrorKind::BadInput,
                     Message::say("%1, %2: there is no number. Add it, or have incomplete rows skipped.", line, name)};
    if (field.find(',') != std::string_view::npos)
        return Error{ErrorKind::BadInput, Message::say("%1, %2: %3 is not a number. Numbers need a decimal point.",
                                                       line, name, shown(field))};
    return notFinite(column);
}

Error TableReading::notFinite(std::size_t column) const
{
    return {ErrorKind::BadInput, Message::say("%1, %2: %3 is not a finite number.", lineText(lines_.number()),
                                              printable(columns_.names[column]), shown(fields_[column]))};
}

Status TableReading::addRow()
{
    if (fields_.size() != columns_.names.size())
        return Error{ErrorKind::BadInput,
                     Message::say("%1 has %2 columns, and those before have %3.", lineText(lines_.number()),
                                  fields_.size(), columns_.names.size())};
    Eigen::Vector3d position;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t column = columns_.position[static_cast<std::size_t>(axis)];
        const Result<double> coordinate = number(column);
        if (!coordinate)
            return coordinate.error();
        if (!std::isfinite(*coordinate))
            return notFinite(column);
        if (std::abs(*coordinate) > largestCoordinate)
            return Error{ErrorKind::BadInput,
                         Message::say("%1, %2: %3 is too large for a position.", lineText(lines_.number()),
                                      printable(columns_.names[column]), shown(fields_[column]))};
        position[axis] = *coordinate;
    }
    const Result<double> value = number(columns_.value);
    if (!value)
        return value.error();
    table_.positions.push_back(position);
    table_.values.push_back(*value);
    return {};
}

Result<PointColumns> TableReading::readColumns()
{
    if (const Status front = readFront(); !front)
        return front.error();
    return std::move(columns_);
}

Result<PointTable> TableReading::run(const Progress& progress)
{
    constexpr std::uint64_t linesBetweenReports = 1 << 14;
    if (const Status front = readFront(); !front)
        return front.error();
    std::string_view line;
    for (; hasRow_ || lines_.next(line); hasRow_ = false) {
        if (!hasRow_)
            if (const Status done = split(line); !done)
                return done.error();
        const Status added = addRow();
        const bool isIncomplete = !added && fields_.size() == columns_.names.size();
        if (!added && !(isIncomplete && request_.skipIncomplete))
            return added.error();
        table_.skippedRows += !added;
        if (lines_.number() % linesBetweenReports == 0) {
            if (progress.cancelled())
                return cancelledError(Message::marked("Reading"));
            progress.report(static_cast<double>(lines_.position()) / static_cast<double>(text_.size()),
                            Message::marked("Reading"));
        }
    }
    if (table_.values.empty())
        return Error{ErrorKind::BadInput, Message::say("it holds no points.")};
    return std::move(table_);
}

/// Whether it can be a table at all.
Status checkTable(std::string_view text)
{
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        return Error{ErrorKind::BadInput, Message::say("it is in UTF-16. Save it as UTF-8.")};
    if (text.find('\0') != std::string_view::npos)
        return Error{ErrorKind::BadInput, Message::say("it is not a text.")};
    if (isChemicalStructure(text))
        return Error{ErrorKind::BadInput,
                     Message::say("it is a chemical structure: elements and where their atoms are. A table of points "
                                  "is wanted, with a value for each x, y and z.")};
    return {};
}

} // namespace

Result<PointColumns> readPointColumns(std::string_view text, const PointTableRequest& request)
{
    if (const Status usable = checkTable(text); !usable)
        return usable.error();
    return TableReading(text, request).readColumns();
}

Result<PointTable> readPointTable(std::string_view text, const PointTableRequest& request, const Progress& progress)
{
    if (const Status usable = checkTable(text); !usable)
        return usable.error();
    return TableReading(text, request).run(progress);
}

bool looksLikePointTable(std::string_view beginning)
{
    constexpr std::uint64_t linesToTry = 3;
    if (beginning.find('\0') != std::string_view::npos)
        return false;
    TextLines lines(beginning);
    std::string_view line;
    std::vector<std::string_view> fields;
    for (std::uint64_t tried = 0; tried < linesToTry && lines.next(line); ++tried) {
        if (!splitFields(line, separatorOf(line), fields))
            continue;
        const auto numbers = static_cast<std::size_t>(std::ranges::count_if(
            fields, [](std::string_view field) { return parseNumber<double>(field).has_value(); }));
        if (numbers >= 4)
            return true;
        if (numbers == fields.size() && !fields.empty()) // sizes, as of a grid: rows have no fewer numbers
            return false;
    }
    return false;
}

} // namespace tetra
