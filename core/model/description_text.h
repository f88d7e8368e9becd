// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/model.h"

#include <string>
#include <string_view>

namespace tetra {

/// The text section of a `.tan` file (FORMAT.md): a description's names and parameters.
std::string textOf(const ModelDescription& description);

/// Fills in names and parameters. Keys that it does not know and lines without a key are skipped.
void readText(std::string_view text, ModelDescription& description);

} // namespace tetra
