// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/camera.h"

#include <span>

namespace tetra {

/// A camera at a time of a film, in seconds.
struct CameraKey {
    double time = 0;
    Camera camera;
};

/// The camera at `time` of a smooth path through keys of rising times, at least one; before the first and after the
/// last it rests. It moves on the sphere around the target: azimuth, the shorter way round, and elevation are
/// smoothCurveAt() of the keys', as are target, field of view and the logarithm of the distance: the horizon stays
/// level, which it would not on the great circle between two directions. Where the keys differ in roll or up axis there
/// is no such horizon: then the quaternions of their orientations go such ways, and are made unit ones. The projection
/// is that of the last key. O(keys).
Camera cameraAt(std::span<const CameraKey> keys, double time);

} // namespace tetra
