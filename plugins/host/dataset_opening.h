// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/data/dataset.h"
#include "plugins/host/plugin_host.h"

namespace tetra {

/// The reader that suits a file best, by its name and first bytes. Errors: a file that cannot be read at all; none
/// suits (then: what can be read, and which readers are missing); a TAn model.
Result<Provided<Reader>> chooseReader(PluginHost& host, const std::filesystem::path& path);

/// Reads a dataset with the reader that suits it best. `values` may hold that reader's parameters and no others
/// (WrongUsage). Every sample is finite. Call from a worker thread; safe from any.
Result<Dataset> openDataset(PluginHost& host, const std::filesystem::path& path, const ParameterValues& values = {},
                            const Progress& progress = {});

/// The name filters of all readers, for a dialog: "NRRD volume (*.nrrd *.nhdr)" ...
std::vector<std::string> readableFiles(PluginHost& host);

} // namespace tetra
