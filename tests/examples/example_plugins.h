// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <memory>

namespace tetra {

/// A host of the plugins of this build and of those of examples/.
inline std::unique_ptr<PluginHost> hostWithExamples()
{
    return std::make_unique<PluginHost>(
        PluginHostOptions{.folders = {TAN_EXAMPLE_FOLDER, TAN_BINARY_DIR "/lib/tan/plugins"}});
}

} // namespace tetra
