// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/camera.h"

#include <string>

namespace tetra {

/// The camera that `--camera` asks for: a named view (front, back, left, right, top, bottom, iso), or a JSON file with
/// any of the keys azimuth, elevation, fieldOfView (degrees), perspective (true or false), target ([x, y, z]) and
/// distance, in units of the dataset. What is left open makes the whole of `bounds` visible.
Result<Camera> cameraFor(const std::string& nameOrFile, const Eigen::AlignedBox3d& bounds);

/// "front, back, ...".
std::string cameraNames();

} // namespace tetra
