// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/render.h>

#include <memory>
#include <string>
#include <vector>

namespace tetra {

/// The pictures are square, with so many pixels along a side; those that are timed have one sample in each.
inline constexpr int paperPictureSide = 512;

/// What one of the paper's pictures shows, from the camera of a first look.
struct PaperPicture {
    std::string mode; ///< id of a renderer
    MeshQuery query;
    std::vector<Isovalue> isovalues{};
    bool drawsSurfacesWithCells = false; ///< hybrid rendering as the paper's program had it, not exact
};

/// A picture and how long the CPU back end takes for it, in seconds: from a camera that it has not seen, with what does
/// not depend on the camera (surfaces, faces, transfer function) ready; the median of three.
struct DrawnPicture {
    Picture picture;
    double seconds = 0;
};

/// Errors: a renderer that is missing, not enough memory, cancelled.
Result<DrawnPicture> drawPicture(PluginHost& host, const std::shared_ptr<const Model>& model,
                                 const PaperPicture& picture, const Progress& progress);

/// How far one picture is from another one of the same size, where at least one of them shows something (C14).
struct Degradation {
    double rootMeanSquare = 0; ///< of the three channels, in % of their range
    double visiblePercent = 0; ///< of pixels that differ by more than a tenth of the range in some channel
};

Degradation degradationOf(const Picture& picture, const Picture& reference);

} // namespace tetra
