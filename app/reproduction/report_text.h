// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/reproduction/report_tables.h"

#include <string>
#include <vector>

namespace tetra {

/// Tables for a terminal: each with its title, its columns aligned, and its remarks.
std::string textOf(const std::vector<ReportTable>& tables);

/// The same as Markdown under a heading.
std::string markdownOf(const std::string& heading, const std::vector<ReportTable>& tables);

} // namespace tetra
