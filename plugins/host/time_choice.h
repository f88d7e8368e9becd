// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/import_options.h"
#include "plugins/host/plugin_host.h"

#include <tan/base.h>

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace tetra {

/// Whether a text for the readers' parameter "time" is something else than the number of a time step, for
/// timeStepOf().
bool isTimeInWords(std::string_view text);

/// The number, from 1, of the time step that a text names by its place, "first" or "last", or by its time, "t=0.25",
/// which is one of the file's to nine digits; of several steps of one time the first. The same for all readers: what
/// steps there are Reader::probe() says, by the other options. Errors: another text, or a time that the file does not
/// have (WrongUsage); those of probeDataset(). As slow as that.
Result<std::int64_t> timeStepOf(PluginHost& host, const std::filesystem::path& path, const ImportOptions& options,
                                std::string_view text, const Progress& progress = {});

} // namespace tetra
