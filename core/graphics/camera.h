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
    double fieldOfView = 30; ///< across the shorter side of the picture, in (0, 180)
    bool perspective = true; ///< else orthographic, showing the same part of the plane through the target
    bool operator==(const Camera&) const = default;
};

/// The camera that shows the whole of `bounds` in a picture of any shape, from the direction of `camera`. It fits the
/// sphere around the box in either projection, so that turning or changing the projection hides nothing.
Camera fitted(const Camera& camera, const Eigen::AlignedBox3d& bounds);
/// The eye moved around the target by angles in degrees, counterclockwise seen from above; elevation stops at the
/// poles.
Camera turned(const Camera& camera, double azimuth, double elevation);
/// Nearer (factor < 1) or farther (factor > 1).
Camera zoomed(const Camera& camera, double factor);
/// The camera moved in the plane of the picture, by fractions of the picture's shorter side at the target.
Camera panned(const Camera& camera, double right, double up);

Eigen::Vector3d eyePosition(const Camera& camera);
/// From dataset coordinates to the eye's: x right, y up, z towards the viewer.
Eigen::Matrix4d viewMatrix(const Camera& camera);
/// From the eye's coordinates to OpenGL's clip space, for a picture of this width / height; near and far enclose
/// `bounds`, but in perspective near stays before the eye. Without bounds they enclose what lies as near to the target
/// as the eye.
Eigen::Matrix4d projectionMatrix(const Camera& camera, double aspectRatio, const Eigen::AlignedBox3d& bounds);

} // namespace tetra
