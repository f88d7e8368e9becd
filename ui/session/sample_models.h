// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "plugins/host/plugin_host.h"

#include <QString>

#include <filesystem>
#include <string>

namespace tetra {

/// Where the models of samples are kept between starts: this user's cache, which may be emptied at any time.
std::filesystem::path sampleFolder();
/// Whether the file lies there.
bool isOfSample(const std::filesystem::path& file);

/// The model of a sample (analytic_fields.h) in the folder; makes dataset and model there unless it is there already,
/// in a size that takes a few seconds. Call from a worker thread. Errors: as of making, saving, reading and building.
Result<std::filesystem::path> sampleModel(PluginHost& host, const std::string& name,
                                          const std::filesystem::path& folder, const Progress& progress = {});

} // namespace tetra
