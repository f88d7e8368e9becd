// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/subcommand.h"
#include "core/data/dataset.h"

#include <filesystem>

namespace tetra {

/// Opens a dataset with what the options say to its reader. Options of other readers are refused.
Result<Dataset> openDatasetWithOptions(const Invocation& invocation, const std::filesystem::path& path,
                                       const Progress& progress);

/// "kind", "points", "cells", "range", "size" and "spacing" of a lattice.
QJsonObject latticeFigures(const Lattice& lattice, SampleType type, const ValueRange& range);
/// The same for people, a line.
std::string latticeText(const Lattice& lattice, SampleType type, const ValueRange& range);

} // namespace tetra
