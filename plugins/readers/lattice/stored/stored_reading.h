// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/readers/lattice/stored/stored_volume.h"

#include <tan/base.h>
#include <tan/data.h>

#include <filesystem>
#include <memory>

namespace tetra {

/// Holds the files of a volume against its header: each must have the bytes of its share of all numbers, also of those
/// that were not chosen; of packed ones only what could hold them. What stands behind them is added to `leftOut`. No
/// samples are read. `opened` is the file that the user opened. Errors name the file that is missing or short.
Status checkStoredFiles(const std::filesystem::path& opened, StoredVolume& volume);

/// The dataset of a volume whose files were checked. Samples that stand in one file as they stand in memory stay there
/// (Dataset::mappedFile); others are decoded. Errors: damaged packing or text; not enough memory; cancelled.
Result<Dataset> readStored(const std::filesystem::path& opened, const StoredVolume& volume, const Progress& progress);

/// What can be chosen of it.
FileContents storedContents(const StoredVolume& volume);

} // namespace tetra
