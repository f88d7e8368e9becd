// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// Takes what is not an absolute path out of the variables of the environment that name a user's folders
/// (XDG_DATA_HOME, XDG_CONFIG_HOME ...), as their rules say: Qt would look below the current folder, which may be
/// somebody else's. At the start of a program, before there are other threads.
void ignoreRelativeFolders();

/// The plugins of this user alone: tan/plugins in the folder for the user's data (XDG_DATA_HOME, ~/.local/share). Need
/// not exist. Empty for a user without a home.
std::filesystem::path userPluginFolder();

/// Why the libraries of the user's own folder, or this one of them, cannot be trusted: others than this user and the
/// administrator can write there. Empty if they can be, or if nothing is there.
Message whyOthersMayWrite(const std::filesystem::path& place);

/// Where plugins are looked for, the first folder winning: those of the environment variable TAN_PLUGIN_PATH (separated
/// by ':'), the user's own, then the place where this program's own plugins lie, seen from `programFolder`: as built,
/// or as installed. Nothing is looked for from the current folder, which may be somebody else's: of a program whose
/// folder is not known (empty) or is not absolute there are only the others.
std::vector<std::filesystem::path> pluginFolders(const std::filesystem::path& programFolder);

/// The same for programs of others, which may lie anywhere: the place of this library's own plugins is seen from where
/// the library was loaded from.
std::vector<std::filesystem::path> pluginFoldersOfLibrary();

/// The ids in the environment variable TAN_PLUGIN_DISABLE (separated by ','): plugins that are not to be loaded, for
/// instance because they crash.
std::vector<std::string> disabledPlugins();

} // namespace tetra
