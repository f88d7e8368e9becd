// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tetra {

/// A turntable camera: it looks at `target` from `distance` away, z is up. Angles in degrees, lengths in the units of
/// the dataset. A value; every change gives a new one.
struct Camera {
    Eigen::Vector3d target{0, 0, 0};
    double distance = 1;
    double azimuth = 30;     ///< around the z axis; 0 looks along +y
    double elevation = 20;   ///< above the xy plane, kept within [-90, 90]
    double fieldOfView = 30; ///< vertical, of the perspective view
    bool perspective = true; ///< else orthographic, showing the same height at the target
};

/// The camera that shows the whole of `bounds` in a picture of any shape, from the direction of `camera`.
Camera fitted(const Camera& camera, const Eigen::AlignedBox3d& bounds);
/// Turned by angles in degrees; elevation stops at the poles.
Camera turned(const Camera& camera, double azimuth, double elevation);
/// Nearer (factor < 1) or farther (factor > 1).
Camera zoomed(const Camera& camera, double factor);
/// Moved in the plane of the picture, by fractions of the picture's height.
Camera panned(const Camera& camera, double right, double up);

Eigen::Vector3d eyePosition(const Camera& camera);
/// From dataset coordinates to the eye's: x right, y up, z towards the viewer.
Eigen::Matrix4d viewMatrix(const Camera& camera);
/// From the eye's coordinates to OpenGL's clip space, for a picture of this width / height; near and far enclose
/// `bounds`.
Eigen::Matrix4d projectionMatrix(const Camera& camera, double aspectRatio, const Eigen::AlignedBox3d& bounds);

} // namespace tetra
