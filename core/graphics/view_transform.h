// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/camera.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tetra {

/// A camera made ready to draw a picture of `width` x `height` pixels or samples.
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
};

ViewTransform makeViewTransform(const Camera& camera, double width, double height, const Eigen::AlignedBox3d& bounds);

} // namespace tetra
