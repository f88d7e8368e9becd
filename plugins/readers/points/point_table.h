// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/points/point_columns.h"

#include <tan/base.h>

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

/// The points of a table, in its order.
struct PointTable {
    std::vector<Eigen::Vector3d> positions;
    std::vector<double> values;
    std::string valueName; ///< empty if the table names no columns
    std::uint64_t skippedRows = 0;
};

/// Reads a table of points: one a line, its fields separated by commas, semicolons, tabs or blanks, with a line of
/// names first or without. Numbers have a decimal point whatever the locale. The error names the line and the column,
/// and ends as a sentence that begins with the file's name and a colon.
Result<PointTable> readPointTable(std::string_view text, const PointTableRequest& request,
                                  const Progress& progress = {});

/// The columns of such a table, by its first line or two.
Result<PointColumns> readPointColumns(std::string_view text, const PointTableRequest& request);

/// Whether the beginning of a file could be that of such a table: text whose first lines have four numbers or more.
bool looksLikePointTable(std::string_view beginning);

} // namespace tetra
