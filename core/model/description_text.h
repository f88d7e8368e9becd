// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset.h"
#include "core/model/model.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tetra {

/// Takes over what a dataset says of itself.
void describeSource(ModelDescription& description, const Dataset& dataset);

/// The text section of a `.tan` file (FORMAT.md): a description's names and parameters. The Error is one of writing
/// `target`: they are too long.
Result<std::string> textOf(const ModelDescription& description, const std::filesystem::path& target);

/// Fills in names and parameters. Keys that it does not know and lines without a key are skipped.
void readText(std::string_view text, ModelDescription& description);

} // namespace tetra
