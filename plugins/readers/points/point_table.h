// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/points/point_columns.h"

#include <tan/base.h>
#include <tan/data.h>

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// How a table of points is to be read.
struct PointTableRequest {
    std::string positions;       ///< as choosePointColumns()
    std::string value;           ///< likewise
    bool skipIncomplete = false; ///< leave out rows without a number where one is needed, instead of refusing them
};

/// A table's columns, and what is taken of them.
struct PointTableHead {
    std::vector<TableColumn> columns;
    PointColumns chosen;
    std::string valueName{};        ///< without its unit; empty if the table names no columns
    std::string lengthUnit{};       ///< of the places, if the table tells one for all three
    std::vector<Taken> taken{};     ///< as Source::taken
    std::vector<Message> leftOut{}; ///< as Source::leftOut
};

/// The points of a table, in its order.
struct PointTable {
    PointTableHead head;
    std::vector<Eigen::Vector3d> positions;
    std::vector<double> values;
    std::uint64_t skippedRows = 0;
    std::uint64_t parts = 1; ///< sections or scans, whose points are all here
};

/// Reads a table of points: one a line, its fields separated by commas, semicolons, tabs or blanks, with a line of
/// names first or without, or in one of the forms of readTableFront(). Numbers have a decimal point whatever the
/// locale. The error names the line and the column, and ends as a sentence that begins with the file's name and a
/// colon.
///
/// Columns that nobody chose are chosen by their names and by the first 10,000 rows at most (of wide tables by the
/// first million fields), which readPointTableHead() reads as well, so that it tells the same.
Result<PointTable> readPointTable(std::string_view text, const PointTableRequest& request,
                                  const Progress& progress = {});

/// What readPointTable() takes, but for PointTableHead::leftOut of what stands behind the first rows.
Result<PointTableHead> readPointTableHead(std::string_view text, const PointTableRequest& request);

/// Whether the beginning of a file could be that of such a table: text whose first lines have four numbers or more, or
/// that begins as one of those forms do.
bool looksLikePointTable(std::string_view beginning);

} // namespace tetra
