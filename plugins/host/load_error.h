// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <string_view>

namespace tetra {

/// Puts what the system said when a plugin could not be loaded into words: names the missing library or symbol, and
/// what to do. `remedy` is the plugin's own advice, or empty.
Message explainLoadError(std::string_view systemText, std::string_view remedy);

} // namespace tetra
