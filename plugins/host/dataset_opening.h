// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/import_options.h"
#include "plugins/host/plugin_host.h"

#include <tan/base.h>
#include <tan/data.h>

#include <optional>
#include <string>

namespace tetra {

/// The reader that suits a file best, by its name and first bytes, or by those of what is in it if it is packed by
/// gzip; of a folder the one that is certain of it (score 1 without any bytes). Errors: a file that cannot be read at
/// all; an empty one, or a folder, of which no reader is certain; none suits (and which readers are missing); a TAn
/// model.
Result<Provided<Reader>> chooseReader(PluginHost& host, const std::filesystem::path& path);

/// The reader with this id, or without one as above.
Result<Provided<Reader>> chooseReader(PluginHost& host, const std::filesystem::path& path,
                                      const std::optional<std::string>& id);

/// Reads a dataset, or a part of it. Files packed by gzip ("map.ccp4.gz") are unpacked for as long as they are read, if
/// the reader does not do so by itself. The values are the reader's parameters and no others (WrongUsage). Every sample
/// is finite. Errors: the reader's, and those of takePart() and scaled(). Call from a worker thread; safe from any.
Result<Dataset> openDataset(PluginHost& host, const std::filesystem::path& path, const ImportOptions& options = {},
                            const Progress& progress = {});

/// What the file offers to choose from, Reader::probe(); the part does not matter. As openDataset(), but quick.
Result<FileContents> probeDataset(PluginHost& host, const std::filesystem::path& path,
                                  const ImportOptions& options = {}, const Progress& progress = {});

/// The name filters of all readers, for a dialog: "NRRD volume (*.nrrd *.nhdr)" ...
std::vector<std::string> readableFiles(PluginHost& host);

} // namespace tetra
