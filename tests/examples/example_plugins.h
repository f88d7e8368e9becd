// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <QString>
#include <QtGlobal>

#include <memory>

namespace tetra {

/// A host of the plugins of this build and of those of examples/: that lie in the folder TAN_EXAMPLE_PLUGINS of the
/// environment, or that this build has made.
inline std::unique_ptr<PluginHost> hostWithExamples()
{
    const QString folder = qEnvironmentVariable("TAN_EXAMPLE_PLUGINS", TAN_EXAMPLE_FOLDER);
    return std::make_unique<PluginHost>(
        PluginHostOptions{.folders = {folder.toStdString(), TAN_BINARY_DIR "/lib/tan/plugins"}});
}

} // namespace tetra
