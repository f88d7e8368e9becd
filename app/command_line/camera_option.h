// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/render.h>

#include <string>

namespace tetra {

/// The camera that `--camera` asks for: a named view (front, back, left, right, top, bottom, iso), or a JSON file with
/// any of the keys that tan/render.h has. What is left open fits `bounds` into a picture of this
/// width / height; named views are `room` times as far as that.
Result<Camera> cameraFor(const std::string& nameOrFile, const Eigen::AlignedBox3d& bounds, double aspectRatio,
                         double room);

/// "front, back, ...".
std::string cameraNames();

} // namespace tetra
