// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace tetra {

/// What a plugin says of itself, as its library has it (plugins/api/plugin_note.h): a JSON text for
/// parsePluginMetadata(). Reads the file and runs nothing of it, whoever made it: of what does not lie in the file
/// nothing is read, and of notes no more than a mebibyte. Errors are whole sentences for the plugin's state: what is no
/// plugin, or is cut short or damaged; a plugin of an earlier TAn, which was one of Qt; a lack of memory or descriptors
/// (OutOfResource).
Result<std::string> pluginText(const std::filesystem::path& library);

/// The same of a library's bytes.
Result<std::string> pluginText(std::span<const std::byte> library);

/// The sentence about a plugin of an earlier TAn.
Message builtForEarlierTan();

/// Puts what the system said when a plugin could not be loaded into words: names the missing library or symbol, and
/// what to do. `remedy` is the plugin's own advice, or empty.
Message explainLoadError(std::string_view systemText, std::string_view remedy);

} // namespace tetra
