// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/render.h>

#include <functional>
#include <string>

namespace tetra {

/// A camera of the same direction that shows whole what a picture is to show.
using Framing = std::function<Camera(const Camera&)>;

/// The camera that `--camera` asks for: a named view (front, back, left, right, top, bottom, iso), or a JSON file with
/// any of the keys that tan/render.h has. How near a view is, `framing` says; of a file that has a target or a
/// distance, what it leaves open fits `bounds` into a picture of this width / height.
Result<Camera> cameraFor(const std::string& nameOrFile, const Framing& framing, const Eigen::AlignedBox3d& bounds,
                         double aspectRatio);

/// "front, back, ...".
std::string cameraNames();

} // namespace tetra
