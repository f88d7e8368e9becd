// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/camera.h"

#include <string>
#include <string_view>

namespace tetra {

/// A camera as a JSON text, and back to the same bits:
///
///     {
///       "azimuth": 30,
///       "elevation": 20,
///       "roll": 0,
///       "up": "z",
///       "fieldOfView": 30,
///       "perspective": true,
///       "trackball": false,
///       "target": [32, 32, 32],
///       "distance": 214.2
///     }
///
/// Angles in degrees, target and distance in the units of the dataset; what points up is x, -x, y, -y, z or -z. Each
/// key may be left out; roll, up and trackball are, where they are as usual, so that older programs can read the text.
std::string cameraToText(const Camera& camera);

/// What the text leaves open is as usual, and fits `bounds` into a picture of this width / height. The error says what
/// is wrong and in which line and column; a key that is not known is one.
Result<Camera> cameraFromText(std::string_view text, const Eigen::AlignedBox3d& bounds, double aspectRatio = 1);

} // namespace tetra
