// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/points/delimited_text.h"

#include <tan/base.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// What is special in the order of a table's lines.
enum class TableForm {
    Plain,
    Sections, ///< CFX: "[Name]", "[Data]" and others; rows stand in each [Data], below their names
    Counted   ///< Leica's .pts: a line with the number of points before those of each scan
};

/// What stands before the rows of a table, and where they begin. Views into the text.
struct TableFront {
    TableForm form = TableForm::Plain;
    std::vector<std::string> names;   ///< one a column; empty if the table names none
    bool namesAreComment = false;     ///< which may say something else
    std::vector<std::string> units{}; ///< one a column, from a line of units; empty if there is none
    std::size_t unusedUnits = 0;      ///< how many there are on a line of units that has another number of them
    std::string lengthUnit{};         ///< of the places, as a comment of COMSOL's says
    std::size_t columns = 0;
    char separator = ',';
    TextLines lines;         ///< gives the first row next
    std::uint64_t count = 0; ///< of the first scan, of a counted table
};

/// Understands lines of names with or without a line of units, names in the last comment before the rows, a leading
/// column of R's that has no name, GSLIB's list of names, CFX's sections, and the counts of Leica's scans. Errors: no
/// line at all, a quote that is not closed, more columns than a table of points has.
Result<TableFront> readTableFront(std::string_view text);

/// Whether these lines begin a table that is no plain one.
bool hasSpecialForm(std::string_view beginning);

/// The rows of a table, one after the other.
class TableRows {
public:
    explicit TableRows(const TableFront& front);
    /// The next row's fields, as many as there are, or none at the end; an empty one behind the last column is dropped.
    /// Errors: a quote that is not closed, another number of points than a scan says, a section of other columns.
    Result<bool> next(std::vector<std::string_view>& fields);
    std::uint64_t number() const noexcept { return lines_.number(); } ///< of its line, from 1
    std::size_t position() const noexcept { return lines_.position(); }
    std::uint64_t parts() const noexcept { return parts_; } ///< sections or scans so far
    /// The sections of more than a line that hold no rows, as CFX's "[Faces]", each once.
    const std::vector<std::string>& otherSections() const noexcept { return otherSections_; }

private:
    Result<bool> findData(std::string_view section);
    Error wrongCount() const;

    TableForm form_;
    std::size_t columns_;
    char separator_;
    TextLines lines_;
    std::uint64_t countLine_ = 1, count_ = 0, rows_ = 0;
    std::uint64_t parts_ = 1;
    std::vector<std::string> otherSections_;
};

} // namespace tetra
