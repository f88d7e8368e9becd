// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace tetra {

class PluginHost;

/// Makes pictures of the window, of every panel and of every dialog in the folder, in light and in dark colours, with a
/// sample in it: light-accuracy.png and so on. Language and scale are those of the program. Returns the exit code.
int makeScreenshots(PluginHost& host, const QString& folder);

} // namespace tetra
