// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/points/point_columns.h"

#include "plugins/readers/points/delimited_text.h"

#include <algorithm>
#include <optional>

namespace tetra {

namespace {

std::string lowerCase(std::string_view text)
{
    std::string lower(text);
    for (char& character : lower)
        if (character >= 'A' && character <= 'Z')
            character = static_cast<char>(character - 'A' + 'a');
    return lower;
}

/// Whether a column that is called so holds this coordinate: "x", "X (m)", "x_m", "Points:0".
bool isCoordinate(std::string_view name, int axis)
{
    const std::string lower = lowerCase(name);
    for (const char* prefix : {"points:", "points_"})
        if (lower == prefix + std::to_string(axis))
            return true;
    return lower[0] == "xyz"[axis] &&
           (lower.size() == 1 || std::string_view(" _([/").find(lower[1]) != std::string::npos);
}

std::string listOf(const std::vector<std::string>& names)
{
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "'" : ", '") + printable(name) + "'";
    return list;
}

std::optional<std::size_t> findColumn(const std::vector<std::string>& names, std::string_view wanted)
{
    if (const auto exact = std::ranges::find(names, wanted); exact != names.end())
        return static_cast<std::size_t>(exact - names.begin());
    if (const auto alike = std::ranges::find(names, lowerCase(wanted), lowerCase); alike != names.end())
        return static_cast<std::size_t>(alike - names.begin());
    const auto number = parseNumber<std::size_t>(wanted);
    if (number && *number >= 1 && *number <= names.size())
        return *number - 1;
    return {};
}

Result<std::size_t> namedColumn(const std::vector<std::string>& names, std::string_view wanted)
{
    if (const auto found = findColumn(names, withoutBlanks(wanted)))
        return *found;
    return Error{ErrorKind::WrongUsage,
                 Message::say("there is no column '%1'; there are %2, or give a number from 1 to %3.",
                              printable(withoutBlanks(wanted)), listOf(names), names.size())};
}

std::array<std::size_t, 3> likelyPositions(const std::vector<std::string>& names)
{
    std::array<std::size_t, 3> found{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto is = [axis](const std::string& name) { return !name.empty() && isCoordinate(name, axis); };
        const auto column = std::ranges::find_if(names, is);
        if (column == names.end())
            return {0, 1, 2};
        found[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(column - names.begin());
    }
    return found;
}

Result<std::array<std::size_t, 3>> positionColumns(const std::vector<std::string>& names, std::string_view wanted)
{
    if (withoutBlanks(wanted) == automaticColumns)
        return likelyPositions(names);
    std::vector<std::string_view> parts;
    std::array<std::size_t, 3> columns{};
    if (!splitFields(wanted, ',', parts) || parts.size() != 3)
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' does not name the three columns of the positions. Give three names or numbers "
                                  "separated by commas, as in x,y,z or 1,2,3.",
                                  printable(wanted))};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Result<std::size_t> column = namedColumn(names, parts[axis]);
        if (!column)
            return column.error();
        if (std::find(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(axis), *column) !=
            columns.begin() + static_cast<std::ptrdiff_t>(axis))
            return Error{ErrorKind::WrongUsage, Message::say("'%1' names the same column twice.", printable(wanted))};
        columns[axis] = *column;
    }
    return columns;
}

} // namespace

Result<PointColumns> choosePointColumns(std::vector<std::string> names, std::string_view wantedPositions,
                                        std::string_view wantedValue)
{
    if (names.size() < 4)
        return Error{
            ErrorKind::BadInput,
            Message::say("it has %1 columns, and points need at least four: x, y, z and a value.", names.size())};
    const Result<std::array<std::size_t, 3>> position = positionColumns(names, wantedPositions);
    if (!position)
        return position.error();
    PointColumns columns{*position, 0, {}};
    const std::string_view value = withoutBlanks(wantedValue);
    if (value == automaticColumns || value.empty()) {
        while (std::ranges::find(*position, columns.value) != position->end())
            ++columns.value;
    } else {
        const Result<std::size_t> column = namedColumn(names, value);
        if (!column)
            return column.error();
        columns.value = *column;
    }
    columns.names = std::move(names);
    return columns;
}

} // namespace tetra
