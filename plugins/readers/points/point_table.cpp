// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/points/point_table.h"

#include "plugins/readers/points/chemical_structure.h"
#include "plugins/readers/points/delimited_text.h"
#include "plugins/readers/points/table_front.h"
#include "plugins/readers/points/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

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

/// That sections hold something else; each once.
void noteSections(const TableRows& rows, std::vector<Message>& leftOut)
{
    for (const std::string& section : rows.otherSections()) {
        const Message text = Message::say("Its section '%1' is not read.", printable(section));
        if (std::ranges::find(leftOut, text) == leftOut.end())
            leftOut.push_back(text);
    }
}

/// The columns of a table as its front and its first rows show them.
std::vector<TableColumn> columnsOf(const TableFront& front, std::vector<Message>& leftOut)
{
    constexpr std::uint64_t mostRows = 10'000, mostFields = 1'000'000;
    std::vector<TableColumn> columns(front.columns);
    for (std::size_t column = 0; column < columns.size(); ++column) {
        columns[column].isNamed = !front.names.empty();
        columns[column].name = front.names.empty() ? parseColumnName("column " + std::to_string(column + 1))
                                                   : parseColumnName(front.names[column]);
        if (!front.units.empty() && columns[column].name.unit.empty())
            columns[column].name.unit = front.units[column] == "-" ? std::string() : front.units[column];
    }
    TableRows rows(front);
    std::vector<std::string_view> fields;
    for (std::uint64_t row = 0; row < mostRows && row * columns.size() < mostFields; ++row) {
        if (const auto more = rows.next(fields); !more.ok() || !*more) // reading says what is wrong
            break;
        for (std::size_t column = 0; column < std::min(columns.size(), fields.size()); ++column)
            if (const auto number = parseNumber<double>(fields[column]))
                columns[column].add(*number);
    }
    noteSections(rows, leftOut);
    return columns;
}

/// The length unit of the places, and a word on what differs.
void noteUnits(const TableFront& front, PointTableHead& head)
{
    std::array<std::string, 3> units;
    for (std::size_t axis = 0; axis < 3; ++axis)
        units[axis] = head.columns[head.chosen.position[axis]].name.unit;
    if (units[0] == units[1] && units[1] == units[2])
        head.lengthUnit = isLengthUnit(units[0]) ? units[0] : units[0].empty() ? front.lengthUnit : std::string();
    else if (std::ranges::none_of(units, [](const std::string& unit) { return unit.empty(); }))
        head.leftOut.push_back(
            Message::say("Its coordinates are in different units (%1, %2, %3) and are used as they are.",
                         printable(units[0]), printable(units[1]), printable(units[2])));
    if (front.unusedUnits > 0)
        head.leftOut.push_back(Message::say("The line of units below its names has %1 of them for %2 columns.",
                                            front.unusedUnits, front.columns));
    const ColumnName& height = head.columns[head.chosen.position[2]].name;
    if (isDepth(height))
        head.leftOut.push_back(Message::say(
            "Its depths ('%1') are used for z as they are: if they are positive, the data are upside down.",
            printable(height.whole)));
}

Result<PointTableHead> headOf(const TableFront& front, const PointTableRequest& request)
{
    PointTableHead head{.columns = {}, .chosen = {}};
    head.columns = columnsOf(front, head.leftOut);
    auto chosen = choosePointColumns(head.columns, front.namesAreComment, request.positions, request.value);
    if (!chosen)
        return chosen.error();
    head.chosen = *chosen;
    if (!front.names.empty())
        head.valueName = labelOf(head.columns, chosen->value);
    std::string places;
    for (const std::size_t column : chosen->position)
        places += (places.empty() ? "" : ", ") + printable(labelOf(head.columns, column));
    head.taken = {{TakenPart::Array, Message(printable(labelOf(head.columns, chosen->value))), chosen->valueGuessed},
                  {TakenPart::Places, Message(places), chosen->positionGuessed}};
    if (const std::string& unit = head.columns[chosen->value].name.unit; !unit.empty())
        head.taken.push_back({TakenPart::Unit, Message(printable(unit)), false});
    noteUnits(front, head);
    return head;
}

class TableReading {
public:
    TableReading(std::string_view text, const PointTableRequest& request, const TableFront& front, PointTableHead head)
        : text_(text), request_(request), rows_(front)
    {
        table_.head = std::move(head);
    }

    Result<PointTable> run(const Progress& progress);

private:
    Status addRow();
    Result<double> number(std::size_t column) const; ///< what is written there, also "nan"
    Error notFinite(std::size_t column) const;
    std::string nameOf(std::size_t column) const
    {
        const std::string& name = table_.head.columns[column].name.whole;
        return printable(name.empty() ? labelOf(table_.head.columns, column) : name);
    }

    std::string_view text_;
    const PointTableRequest& request_;
    TableRows rows_;
    std::vector<std::string_view> fields_;
    PointTable table_;
};

Result<double> TableReading::number(std::size_t column) const
{
    const std::string_view field = fields_[column];
    if (const auto number = parseNumber<double>(field))
        return *number;
    const Message line = lineText(rows_.number());
    const std::string name = nameOf(column);
    if (field.empty())
        return Error{ErrorKind::BadInput,
                     Message::say("%1, %2: a number is missing. Add it, or have incomplete rows skipped.", line, name)};
    if (field.find(',') != std::string_view::npos)
        return Error{ErrorKind::BadInput, Message::say("%1, %2: %3 is not a number. Numbers need a decimal point.",
                                                       line, name, shown(field))};
    return notFinite(column);
}

Error TableReading::notFinite(std::size_t column) const
{
    return {ErrorKind::BadInput, Message::say("%1, %2: %3 is not a finite number.", lineText(rows_.number()),
                                              nameOf(column), shown(fields_[column]))};
}

Status TableReading::addRow()
{
    if (fields_.size() != table_.head.columns.size())
        return Error{ErrorKind::BadInput,
                     Message::say("%1 has %2 columns, and the lines before have %3.", lineText(rows_.number()),
                                  fields_.size(), table_.head.columns.size())};
    Eigen::Vector3d position;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t column = table_.head.chosen.position[static_cast<std::size_t>(axis)];
        const Result<double> coordinate = number(column);
        if (!coordinate)
            return coordinate.error();
        if (!std::isfinite(*coordinate))
            return notFinite(column);
        if (std::abs(*coordinate) > largestCoordinate)
            return Error{ErrorKind::BadInput,
                         Message::say("%1, %2: %3 is too large for a position.", lineText(rows_.number()),
                                      nameOf(column), shown(fields_[column]))};
        position[axis] = *coordinate;
    }
    const Result<double> value = number(table_.head.chosen.value);
    if (!value)
        return value.error();
    table_.positions.push_back(position);
    table_.values.push_back(*value);
    return {};
}

Result<PointTable> TableReading::run(const Progress& progress)
{
    constexpr std::uint64_t rowsBetweenReports = 1 << 14;
    for (std::uint64_t row = 1;; ++row) {
        const Result<bool> more = rows_.next(fields_);
        if (!more.ok())
            return more.error();
        if (!*more)
            break;
        const Status added = addRow();
        const bool isIncomplete = !added && fields_.size() == table_.head.columns.size();
        if (!added && !(isIncomplete && request_.skipIncomplete))
            return added.error();
        table_.skippedRows += !added;
        if (row % rowsBetweenReports == 0) {
            if (progress.cancelled())
                return cancelledError(Message::marked("Reading"));
            progress.report(static_cast<double>(rows_.position()) / static_cast<double>(text_.size()),
                            Message::marked("Reading"));
        }
    }
    if (table_.values.empty())
        return Error{ErrorKind::BadInput, Message::say("it holds no points.")};
    table_.parts = rows_.parts();
    noteSections(rows_, table_.head.leftOut);
    return std::move(table_);
}

/// Whether it can be a table at all.
Status checkTable(std::string_view text)
{
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        return Error{ErrorKind::BadInput, Message::say("it is in UTF-16. Save it as UTF-8.")};
    if (text.find('\0') != std::string_view::npos)
        return Error{ErrorKind::BadInput, Message::say("it is not text.")};
    if (isChemicalStructure(text))
        return Error{ErrorKind::BadInput,
                     Message::say("it is a chemical structure: elements and the positions of their atoms. A table of "
                                  "points is needed, with a value for each x, y and z.")};
    return {};
}

} // namespace

Result<PointTableHead> readPointTableHead(std::string_view text, const PointTableRequest& request)
{
    if (const Status usable = checkTable(text); !usable)
        return usable.error();
    const auto front = readTableFront(text);
    return front ? headOf(*front, request) : front.error();
}

Result<PointTable> readPointTable(std::string_view text, const PointTableRequest& request, const Progress& progress)
{
    if (const Status usable = checkTable(text); !usable)
        return usable.error();
    const auto front = readTableFront(text);
    if (!front)
        return front.error();
    auto head = headOf(*front, request);
    if (!head)
        return head.error();
    return TableReading(text, request, *front, *std::move(head)).run(progress);
}

bool looksLikePointTable(std::string_view beginning)
{
    constexpr std::uint64_t linesToTry = 3;
    if (beginning.find('\0') != std::string_view::npos)
        return false;
    if (hasSpecialForm(beginning))
        return true;
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
