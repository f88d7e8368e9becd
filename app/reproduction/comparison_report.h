// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/reproduction/builder_comparison.h"
#include "app/reproduction/report_tables.h"
#include "core/base/json.h"

#include <filesystem>
#include <vector>

namespace tetra {

/// The comparison of builders for people, a table a dataset.
std::vector<ReportTable> comparisonTables(const std::vector<ComparedDataset>& datasets);

/// [{"dataset", "domain", "points", "skipped", "builds": [{"builder", "refused", "seconds", "bytes", ...}], "levels":
/// [{"error", "warping", "refinement": {"sites", "tetrahedra"}, "decimation": {...}}]}].
JsonArray comparisonFigures(const std::vector<ComparedDataset>& datasets);

/// Draws sites against error of each class of domains into `folder`, as PNG and SVG; gives the files written.
/// Errors: a file that cannot be written, no font.
Result<std::vector<std::filesystem::path>> drawComparison(const std::vector<ComparedDataset>& datasets,
                                                          const std::filesystem::path& folder);

} // namespace tetra
