// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/view_transform.h"

namespace tetra {

ViewTransform makeViewTransform(const Camera& camera, double width, double height, const Eigen::AlignedBox3d& bounds)
{
    const Eigen::Matrix4d view = viewMatrix(camera);
    const Eigen::Matrix4d projection = projectionMatrix(camera, width / height, bounds);
    ViewTransform transform;
    transform.width = width;
    transform.height = height;
    transform.clipFromWorld = projection * view;
    transform.perspective = camera.perspective;

    const Eigen::Matrix3d worldFromEye = view.topLeftCorner<3, 3>().transpose();
    if (!camera.perspective) {
        transform.towardsEye = worldFromEye.col(2).cast<float>();
        return transform;
    }
    // What is seen one unit before the eye, at the normalised place (u, v), lies at (u / P00, v / P11, -1).
    const Eigen::Vector3d perU = worldFromEye.col(0) / projection(0, 0);
    const Eigen::Vector3d perV = worldFromEye.col(1) / projection(1, 1);
    transform.towardsEye = (worldFromEye.col(2) + perU - perV).cast<float>();
    transform.towardsEyePerX = (-perU * (2 / width)).cast<float>();
    transform.towardsEyePerY = (perV * (2 / height)).cast<float>();
    return transform;
}

} // namespace tetra
