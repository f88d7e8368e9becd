// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// Where plugins are looked for, the first folder winning: those of the environment variable TAN_PLUGIN_PATH (separated
/// by ':'), then the place where this program's own plugins lie, seen from `programFolder`: as built, or as installed.
std::vector<std::filesystem::path> pluginFolders(const std::filesystem::path& programFolder);

/// The ids in the environment variable TAN_PLUGIN_DISABLE (separated by ','): plugins that are not to be loaded, for
/// instance because they crash.
std::vector<std::string> disabledPlugins();

} // namespace tetra
