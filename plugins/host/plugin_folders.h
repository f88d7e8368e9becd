// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The plugins of this user alone: tan/plugins in the folder for the user's data (XDG_DATA_HOME, ~/.local/share). Need
/// not exist.
std::filesystem::path userPluginFolder();

/// Where plugins are looked for, the first folder winning: those of the environment variable TAN_PLUGIN_PATH (separated
/// by ':'), the user's own, then the place where this program's own plugins lie, seen from `programFolder`: as built,
/// or as installed.
std::vector<std::filesystem::path> pluginFolders(const std::filesystem::path& programFolder);

/// The ids in the environment variable TAN_PLUGIN_DISABLE (separated by ','): plugins that are not to be loaded, for
/// instance because they crash.
std::vector<std::string> disabledPlugins();

} // namespace tetra
