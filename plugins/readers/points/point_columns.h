// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/points/column_names.h"

#include <tan/base.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// A column of a table, as its name and its first rows show it.
struct TableColumn {
    ColumnName name;            ///< may be empty; "column 3" where the table names none
    bool isNamed = true;        ///< whether the table has names
    std::uint64_t numbers = 0;  ///< in the rows that were looked at, finite ones
    bool isConstant = true;     ///< as far as those rows go
    bool risesByOne = true;     ///< whole numbers, each one more than that before
    double first = 0, last = 0; ///< of those numbers

    /// Looks at a number of the next row.
    void add(double number);
};

/// What people call it: its quantity; its whole name where another column has the same quantity; "column 3" without a
/// name. Each is understood as the name of a wanted column.
std::string labelOf(std::span<const TableColumn> columns, std::size_t column);
/// Of all columns.
std::vector<std::string> labelsOf(std::span<const TableColumn> columns);

/// Which columns of a table are the positions and the values, counted from 0.
struct PointColumns {
    std::array<std::size_t, 3> position{0, 1, 2};
    bool positionGuessed = false; ///< nobody says that they are these
    std::size_t value = 3;
    bool valueGuessed = false; ///< others could be meant
};

/// What finds the columns by itself.
inline constexpr std::string_view automaticColumns = "automatic";

/// `wantedPositions`: three names or numbers from 1, separated by commas, or "automatic": by their names, findPlaces();
/// where the table names none, the first three, which is a guess, without a column in front of five or more that counts
/// the rows from 0 or 1. `wantedValue`: a name, a number, or "automatic": the first of the others that is a measured
/// quantity, by its name and as it varies; heights and times, coordinates of another system, whole numbers that rise
/// by one, constants, counters and texts only where there is nothing else, in this order. `namesMayBeNone`: the names
/// may be no names, so that none of them has to be a place. Errors: fewer than four columns (BadInput); no such column,
/// names of which not all three are places (WrongUsage), with the names there are.
Result<PointColumns> choosePointColumns(std::span<const TableColumn> columns, bool namesMayBeNone,
                                        std::string_view wantedPositions, std::string_view wantedValue);

} // namespace tetra
