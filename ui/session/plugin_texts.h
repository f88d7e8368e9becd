// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

namespace tetra {

/// A text that a plugin or the library wrote for people, in their language if the translation has it (context
/// "Plugin"), else as it is. plugin_texts.cpp lists those of the plugins that come with the program.
QString pluginText(const std::string& text);

} // namespace tetra
