// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/reproduction/reproduction.h"
#include "core/base/json.h"

#include <string>

namespace tetra {

/// A reproduction as text for a terminal: each table, ours beside the paper's, with differences in percent.
std::string textReport(const Reproduction& reproduction);

/// The same as Markdown.
std::string markdownReport(const Reproduction& reproduction);

/// {"tables": [{"table", "rows": [{"dataset", "variant", "error", "warping", "paper": {...}, "ours": {...}}],
/// "models": [{...}]}]}, differences in percent.
JsonObject jsonReport(const Reproduction& reproduction);

} // namespace tetra
