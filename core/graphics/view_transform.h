// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/camera.h"
#include "core/graphics/sample_rectangle.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tetra {

/// A camera made ready to draw a picture of `width` x `height` pixels or samples.
///
/// How near a point is, is told by q = 1 / w in perspective, else -w, with its distance w from the eye along the view's
/// axis, in units of the camera's distance: q is affine in the picture on every plane, and larger is nearer.
struct ViewTransform {
    double width = 1;
    double height = 1;
    Eigen::Matrix4d clipFromWorld = Eigen::Matrix4d::Identity();
    bool perspective = true;
    /// The direction from what is seen towards the eye, not of unit length, in world coordinates, for a place in the
    /// picture measured from its upper left corner: towardsEye + x * towardsEyePerX + y * towardsEyePerY.
    Eigen::Vector3f towardsEye{0, 0, 1};
    Eigen::Vector3f towardsEyePerX{0, 0, 0};
    Eigen::Vector3f towardsEyePerY{0, 0, 0};
    /// Of clip space: q = nearnessPerClip * z / w + nearnessAtZero, in perspective of 1 in place of z.
    double nearnessPerClip = -1;
    double nearnessAtZero = 0;
};

/// q of a point in clip space.
inline double nearnessOf(const ViewTransform& transform, const Eigen::Vector4d& clip)
{
    const double numerator = transform.perspective ? 1 : clip.z();
    return transform.nearnessPerClip * numerator / clip.w() + transform.nearnessAtZero;
}

ViewTransform makeViewTransform(const Camera& camera, double width, double height, const Eigen::AlignedBox3d& bounds);
/// The same view of a part of the picture, as a picture of its own.
ViewTransform partOf(const ViewTransform& whole, const SampleRectangle& part);

} // namespace tetra
