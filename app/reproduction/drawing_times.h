// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>

#include <memory>

namespace tetra {

/// How long the CPU back end takes for a picture of a mesh, in seconds: from a camera that it has not seen, with what
/// does not depend on the camera (surfaces, faces, transfer function) ready.
struct DrawingTimes {
    double surface = 0; ///< of one isovalue
    double volume = 0;  ///< through the default transfer function
    double hybrid = 0;  ///< both
};

/// The pictures that are timed are square, with so many pixels along a side and one sample in each.
inline constexpr int timedPictureSide = 512;

/// Draws each picture of such a mesh a few times and takes the medians. Errors: a renderer that is missing, not enough
/// memory, cancelled.
Result<DrawingTimes> measureDrawing(PluginHost& host, const std::shared_ptr<const Model>& model, const MeshQuery& query,
                                    double isovalue, const Progress& progress);

} // namespace tetra
