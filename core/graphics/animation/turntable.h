// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/camera.h"

namespace tetra {

/// A film of the camera moving around its target.
struct Turntable {
    /// Round the up axis; or up and down, around the horizontal one, and back: the camera does not go over a pole,
    /// where what is seen would turn upside down.
    enum class Axis { Vertical, Horizontal };
    Axis axis = Axis::Vertical;
    double degrees = 360; ///< to turn by; up and down: from the lowest to the highest place
    int frames = 120;
    bool operator==(const Turntable&) const = default;
};

/// The camera of a frame, from 0 on: `start` at frame 0. Frames are spaced evenly over the whole way so that the one
/// after the last would end it: a whole turn, or up and down, can be played over and over. Up and down it stops at the
/// poles.
Camera turntableCamera(const Camera& start, const Turntable& turntable, int frame);

} // namespace tetra
