// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <span>
#include <string>

namespace tetra {

/// A text that a plugin or the library wrote for people, in their language if the translation has it (context
/// "Plugin"), else as it is.
QString pluginText(const std::string& text);

/// The texts of the plugins that come with the program, for which translations exist.
std::span<const char* const> translatedPluginTexts();

} // namespace tetra
