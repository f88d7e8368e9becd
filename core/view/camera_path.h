// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>
#include <tan/view.h>

#include <span>

namespace tetra {

/// The value at `time` of a curve through (times[i], values[i]): once continuously differentiable, between two keys
/// never outside their values, constant where they are equal, at rest before the first key and after the last.
/// `times` rise strictly and are as many as `values`, at least one. O(log keys). (F. N. Fritsch, J. Butland: A method
/// for constructing local monotone piecewise cubic interpolants, SIAM J. Sci. Stat. Comput. 5, 1984.)
double smoothCurveAt(std::span<const double> times, std::span<const double> values, double time);

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

/// The camera of a frame, from 0 on: `start` at frame 0. Frames are spaced evenly over the whole way so that the one
/// after the last would end it: a whole turn, or up and down, can be played over and over. Up and down it stops at the
/// poles.
Camera turntableCamera(const Camera& start, const Turntable& turntable, int frame);

} // namespace tetra
