// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

namespace tetra {

/// The plugins as they were built, as the program gets them.
inline PluginHost& pluginsOfThisBuild()
{
    static PluginHost host({.folders = {TAN_BINARY_DIR "/lib/tan/plugins"}});
    return host;
}

} // namespace tetra
