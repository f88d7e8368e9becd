// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/import_options.h"
#include "plugins/host/plugin_host.h"

#include <filesystem>

namespace tetra {

/// How a file was opened last, kept in the user's settings for the fifty files that were opened so last.
void rememberImport(const std::filesystem::path& path, const ImportOptions& options);

/// As far as its reader still knows it; nothing chosen if the file was never opened so.
ImportOptions rememberedImport(const std::filesystem::path& path, PluginHost& host);

} // namespace tetra
