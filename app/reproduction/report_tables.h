// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/reproduction/reproduction.h"

#include <string>
#include <vector>

namespace tetra {

/// One table of a report: rows of cells, the first row being the heads, and what is to be said of it.
struct ReportTable {
    std::string title;
    std::vector<std::vector<std::string>> rows; ///< empty if there were no data
    std::vector<std::string> remarks;
};

/// The tables of a report for people, one a model of the paper and one for Table 4.
std::vector<ReportTable> reportTables(const Reproduction& reproduction);

/// How many tetrahedra ever lived for each one of the finest mesh (the paper: about 2.5). 0 if that is not known.
struct HistoryRatios {
    double ours = 0;
    double paper = 0;
};
HistoryRatios historyRatios(const ReproducedModel& model);

/// 100 * (ours - paper) / paper.
double differencePercent(std::uint64_t ours, std::uint64_t paper);

} // namespace tetra
