// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <string>
#include <string_view>

namespace tetra {

/// Which axis of the dataset points up, and which way.
enum class UpAxis { X, MinusX, Y, MinusY, Z, MinusZ };

/// A camera that looks at `target` from `distance` away. Angles in degrees, lengths in the units of the dataset. A
/// value; every change gives a new one.
struct Camera {
    Eigen::Vector3d target{0, 0, 0};
    double distance = 1;
    /// Around the up axis, counterclockwise seen from above. 0 looks along +y if z is up or down, along -z if y is,
    /// along +z if x is.
    double azimuth = 30;
    double elevation = 20; ///< above the plane across the up axis, kept within [-90, 90]
    double roll = 0;       ///< about the line of sight: what is seen is turned clockwise by it
    UpAxis up = UpAxis::Z;
    double fieldOfView = 30; ///< across the shorter side of the picture, in (0, 180)
    bool perspective = true; ///< else orthographic, showing the same part of the plane through the target
    /// How it is turned by hand: in any direction, like a ball, roll included; else like a turntable, around the up
    /// axis and up and down.
    bool trackball = false;
    bool operator==(const Camera&) const = default;
};

/// The camera that looks at the middle of `bounds` from the direction of `camera`, from where the box fills a picture
/// of this width / height but for a narrow margin. Fitted to 1 the box is seen whole in a picture of any shape.
Camera fitted(const Camera& camera, const Eigen::AlignedBox3d& bounds, double aspectRatio = 1);
/// The eye moved around the target by angles in degrees, counterclockwise seen from above; elevation stops at the
/// poles.
Camera turned(const Camera& camera, double azimuth, double elevation);
/// What is seen turned clockwise about the line of sight, in degrees.
Camera rolled(const Camera& camera, double degrees);
/// What is seen turned about the target: by a rotation in the eye's coordinates.
Camera rotated(const Camera& camera, const Eigen::Matrix3d& rotation);
/// Another axis upright, seen from the same azimuth and elevation, the horizon level.
Camera upright(const Camera& camera, UpAxis up);
/// The same axis, the other way.
UpAxis opposite(UpAxis up);
/// Nearer (factor < 1) or farther (factor > 1).
Camera zoomed(const Camera& camera, double factor);
/// The camera moved in the plane of the picture, by fractions of the picture's shorter side at the target.
Camera panned(const Camera& camera, double right, double up);

Eigen::Vector3d eyePosition(const Camera& camera);
/// How the eye is turned: the columns are its right, its up and its back, towards the viewer, in dataset coordinates.
Eigen::Matrix3d eyeAxes(const Camera& camera);
/// The camera turned so, with its own up axis.
Camera withEyeAxes(const Camera& camera, const Eigen::Matrix3d& axes);
/// From dataset coordinates to the eye's: x right, y up, z towards the viewer.
Eigen::Matrix4d viewMatrix(const Camera& camera);
/// From the eye's coordinates to OpenGL's clip space, for a picture of this width / height; near and far enclose
/// `bounds`, but in perspective near stays before the eye. Without bounds they enclose what lies as near to the target
/// as the eye.
Eigen::Matrix4d projectionMatrix(const Camera& camera, double aspectRatio, const Eigen::AlignedBox3d& bounds);

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
