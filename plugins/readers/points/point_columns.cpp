// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/points/point_columns.h"

#include "plugins/readers/points/delimited_text.h"
#include "plugins/readers/points/small_letters.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace tetra {

namespace {

using Columns = std::span<const TableColumn>;

constexpr std::uint64_t leastToBeConstant = 2, leastToCount = 3;

std::string byNumber(std::size_t column)
{
    return "column " + std::to_string(column + 1);
}

std::string wholeNameOf(Columns columns, std::size_t column)
{
    const std::string& name = columns[column].name.whole;
    return name.empty() ? byNumber(column) : name;
}

std::string listOf(Columns columns)
{
    constexpr std::size_t most = 30;
    std::string list;
    for (std::size_t column = 0; column < std::min(columns.size(), most); ++column)
        list += (list.empty() ? "'" : ", '") + printable(wholeNameOf(columns, column)) + "'";
    return columns.size() > most ? list + ", ..." : list;
}

/// Whether the name is that of a column with its unit, however that is set off: "T K", "t [K]", "T (K)".
bool isNameWithUnit(const ColumnName& column, std::string_view wanted)
{
    if (column.unit.empty())
        return false;
    const ColumnName asked = parseColumnName(wanted);
    const std::string quantity = inSmallLetters(column.quantity);
    return (asked.unit == column.unit && inSmallLetters(asked.quantity) == quantity) ||
           inSmallLetters(wanted) == quantity + " " + inSmallLetters(column.unit);
}

std::optional<std::size_t> findColumn(Columns columns, std::string_view wanted)
{
    const auto number = [&](auto found) { return static_cast<std::size_t>(found - columns.begin()); };
    for (const auto part : {&ColumnName::whole, &ColumnName::quantity}) {
        if (wanted.empty())
            return {};
        const auto nameOf = [&](const TableColumn& column) { return column.name.*part; };
        if (const auto exact = std::ranges::find(columns, wanted, nameOf); exact != columns.end())
            return number(exact);
        const auto lower = [&](const TableColumn& column) { return inSmallLetters(nameOf(column)); };
        if (const auto alike = std::ranges::find(columns, inSmallLetters(wanted), lower); alike != columns.end())
            return number(alike);
    }
    const auto named = [&](const TableColumn& column) { return isNameWithUnit(column.name, wanted); };
    if (const auto found = std::ranges::find_if(columns, named); found != columns.end())
        return number(found);
    constexpr std::string_view before = "column "; // as in labelOf()
    const auto place = parseNumber<std::size_t>(wanted.substr(wanted.starts_with(before) ? before.size() : 0));
    if (place && *place >= 1 && *place <= columns.size())
        return *place - 1;
    return {};
}

Result<std::size_t> namedColumn(Columns columns, std::string_view wanted)
{
    if (const auto found = findColumn(columns, withoutBlanks(wanted)))
        return *found;
    return Error{ErrorKind::WrongUsage,
                 Message::say("there is no column '%1'; there are %2, or give a number from 1 to %3.",
                              printable(withoutBlanks(wanted)), listOf(columns), columns.size())};
}

/// Of a table without names.
PointColumns firstPositions(Columns columns)
{
    const TableColumn& front = columns[0];
    const bool counts = front.numbers >= leastToCount && front.risesByOne && (front.first == 0 || front.first == 1);
    const std::size_t first = counts && columns.size() > 4 ? 1 : 0;
    return {.position = {first, first + 1, first + 2}, .positionGuessed = true};
}

Result<PointColumns> automaticPositions(Columns columns, bool namesMayBeNone)
{
    if (!columns[0].isNamed)
        return firstPositions(columns);
    std::vector<ColumnName> names;
    for (const TableColumn& column : columns)
        names.push_back(column.name);
    if (const auto places = findPlaces(names))
        return PointColumns{.position = places->columns, .positionGuessed = places->guessed};
    if (namesMayBeNone)
        return firstPositions(columns);
    if (const auto filled = static_cast<std::size_t>(
            std::ranges::count_if(columns, [](const TableColumn& column) { return column.numbers > 0; }));
        filled > 0 && filled < 4)
        return Error{
            ErrorKind::BadInput,
            Message::say("it has numbers in %1 of its columns, and points need at least four: x, y, z and a value.",
                         filled)};
    return Error{ErrorKind::WrongUsage,
                 Message::say("which of its columns are x, y and z? It has %1. Name three of them with '--positions', "
                              "or in Import Options, as in --positions %2.",
                              listOf(columns), "1,2,3")};
}

Result<PointColumns> positionColumns(Columns columns, bool namesMayBeNone, std::string_view wanted)
{
    if (withoutBlanks(wanted) == automaticColumns)
        return automaticPositions(columns, namesMayBeNone);
    std::vector<std::string_view> parts;
    PointColumns chosen;
    if (!splitFields(wanted, ',', parts) || parts.size() != 3)
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' does not name the three columns of the positions. Give three names or numbers "
                                  "separated by commas, as in x,y,z or 1,2,3.",
                                  printable(wanted))};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Result<std::size_t> column = namedColumn(columns, parts[axis]);
        if (!column)
            return column.error();
        const auto before = std::span(chosen.position).first(axis);
        if (std::ranges::find(before, *column) != before.end())
            return Error{ErrorKind::WrongUsage, Message::say("'%1' names the same column twice.", printable(wanted))};
        chosen.position[axis] = *column;
    }
    return chosen;
}

/// The larger, the less likely it is the value.
enum class Rank { Quantity, HeightOrTime, Coordinate, RisesByOne, Constant, Counter, Text };

Rank rankOf(const TableColumn& column)
{
    if (column.numbers == 0)
        return Rank::Text;
    Rank rank = Rank::Quantity;
    switch (column.isNamed ? kindOf(column.name) : ColumnKind::Quantity) {
    case ColumnKind::Quantity: break;
    case ColumnKind::HeightOrTime: rank = Rank::HeightOrTime; break;
    case ColumnKind::Coordinate: rank = Rank::Coordinate; break;
    case ColumnKind::Counter: return Rank::Counter;
    }
    if (column.numbers >= leastToBeConstant && column.isConstant)
        return Rank::Constant;
    return column.numbers >= leastToCount && column.risesByOne ? std::max(rank, Rank::RisesByOne) : rank;
}

void chooseValue(Columns columns, PointColumns& chosen)
{
    std::optional<Rank> best;
    std::size_t likely = 0;
    for (std::size_t column = 0; column < columns.size(); ++column) {
        if (std::ranges::find(chosen.position, column) != chosen.position.end())
            continue;
        const Rank rank = rankOf(columns[column]);
        // One that rises by one and is called otherwise may be a quantity after all.
        likely += rank <= Rank::RisesByOne && rank != Rank::Coordinate;
        if (!best || rank < *best) {
            best = rank;
            chosen.value = column;
        }
    }
    const bool isOnlyColumn = columns.size() == 4 && columns[chosen.value].isNamed && *best < Rank::RisesByOne;
    chosen.valueGuessed =
        !isOnlyColumn && (likely != 1 || *best > Rank::HeightOrTime || !columns[chosen.value].isNamed);
}

} // namespace

void TableColumn::add(double number)
{
    if (!std::isfinite(number))
        return;
    isConstant = isConstant && (numbers == 0 || number == last);
    risesByOne = risesByOne && number == std::floor(number) && (numbers == 0 || number == last + 1);
    if (numbers == 0)
        first = number;
    last = number;
    ++numbers;
}

std::vector<std::string> labelsOf(std::span<const TableColumn> columns)
{
    std::map<std::string, std::uint64_t> alike;
    for (const TableColumn& column : columns)
        ++alike[inSmallLetters(column.name.quantity)];
    std::vector<std::string> labels;
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const ColumnName& name = columns[column].name;
        labels.push_back(alike[inSmallLetters(name.quantity)] == 1 && !name.whole.empty()
                             ? name.quantity
                             : wholeNameOf(columns, column));
    }
    return labels;
}

std::string labelOf(std::span<const TableColumn> columns, std::size_t column)
{
    return labelsOf(columns)[column];
}

Result<PointColumns> choosePointColumns(std::span<const TableColumn> columns, bool namesMayBeNone,
                                        std::string_view wantedPositions, std::string_view wantedValue)
{
    if (columns.size() < 4)
        return Error{
            ErrorKind::BadInput,
            Message::say("it has %1 columns, and points need at least four: x, y, z and a value.", columns.size())};
    Result<PointColumns> chosen = positionColumns(columns, namesMayBeNone, wantedPositions);
    if (!chosen)
        return chosen.error();
    const std::string_view value = withoutBlanks(wantedValue);
    if (value == automaticColumns || value.empty()) {
        chooseValue(columns, *chosen);
        chosen->valueGuessed = chosen->valueGuessed || (namesMayBeNone && chosen->positionGuessed);
        return chosen;
    }
    const Result<std::size_t> column = namedColumn(columns, value);
    if (!column)
        return column.error();
    chosen->value = *column;
    return chosen;
}

} // namespace tetra
