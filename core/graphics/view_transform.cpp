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
        // z = P22 * zEye + P23, and q = zEye / distance.
        transform.nearnessPerClip = 1 / (projection(2, 2) * camera.distance);
        transform.nearnessAtZero = -projection(2, 3) * transform.nearnessPerClip;
        transform.towardsEye = worldFromEye.col(2).cast<float>();
        return transform;
    }
    transform.nearnessPerClip = camera.distance;
    // What is seen one unit before the eye, at the normalised place (u, v), lies at (u / P00, v / P11, -1).
    const Eigen::Vector3d perU = worldFromEye.col(0) / projection(0, 0);
    const Eigen::Vector3d perV = worldFromEye.col(1) / projection(1, 1);
    transform.towardsEye = (worldFromEye.col(2) + perU - perV).cast<float>();
    transform.towardsEyePerX = (-perU * (2 / width)).cast<float>();
    transform.towardsEyePerY = (perV * (2 / height)).cast<float>();
    return transform;
}

ViewTransform partOf(const ViewTransform& whole, const SampleRectangle& part)
{
    ViewTransform result = whole;
    result.width = part.width();
    result.height = part.height();
    const auto w = whole.clipFromWorld.row(3);
    result.clipFromWorld.row(0) =
        (whole.clipFromWorld.row(0) * whole.width + w * (whole.width - 2 * part.left - result.width)) / result.width;
    result.clipFromWorld.row(1) =
        (whole.clipFromWorld.row(1) * whole.height - w * (result.height - whole.height + 2 * part.top)) / result.height;
    result.towardsEye +=
        static_cast<float>(part.left) * whole.towardsEyePerX + static_cast<float>(part.top) * whole.towardsEyePerY;
    return result;
}

} // namespace tetra
