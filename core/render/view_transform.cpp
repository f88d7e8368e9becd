// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/view_transform.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

    transform.cameraFromWorld = view.topLeftCorner<3, 3>().cast<float>();
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
        (whole.clipFromWorld.row(1) * whole.height + w * (result.height - whole.height + 2 * part.top)) / result.height;
    result.towardsEye +=
        static_cast<float>(part.left) * whole.towardsEyePerX + static_cast<float>(part.top) * whole.towardsEyePerY;
    return result;
}

namespace {

/// The part of a segment that lies behind the near plane (z = -w), false if none.
bool clipToNear(Eigen::Vector4d& a, Eigen::Vector4d& b)
{
    const double insideA = a.z() + a.w();
    const double insideB = b.z() + b.w();
    if (!(insideA >= 0 || insideB >= 0) || !a.allFinite() || !b.allFinite())
        return false;
    if (insideA < 0)
        a = b + (a - b) * (insideB / (insideB - insideA));
    else if (insideB < 0)
        b = a + (b - a) * (insideA / (insideA - insideB));
    return a.w() > 0 && b.w() > 0;
}

Eigen::Vector4d moved(const Eigen::Vector4d& corner, const Eigen::Vector2d& samples, const ViewTransform& transform)
{
    const Eigen::Vector2d normalised(samples.x() * 2 / transform.width, samples.y() * 2 / transform.height);
    Eigen::Vector4d result = corner;
    result.head<2>() += normalised * corner.w();
    return result;
}

LineQuad quadAround(const Eigen::Vector4d& a, const Eigen::Vector4d& b, const ViewTransform& transform, double width)
{
    const Eigen::Vector2d difference = b.head<2>() / b.w() - a.head<2>() / a.w();
    const Eigen::Vector2d inSamples(difference.x() * transform.width / 2, difference.y() * transform.height / 2);
    const double length = inSamples.norm();
    const Eigen::Vector2d along =
        length > 0 ? Eigen::Vector2d(inSamples * (width / 2 / length)) : Eigen::Vector2d(width / 2, 0);
    const Eigen::Vector2d across(-along.y(), along.x());
    return {moved(a, -along - across, transform), moved(b, along - across, transform),
            moved(b, along + across, transform), moved(a, across - along, transform)};
}

} // namespace

std::vector<LineQuad> thickLines(const LineSet& lines, const ViewTransform& transform, double width)
{
    const auto project = [&](std::uint32_t point) -> Eigen::Vector4d {
        return transform.clipFromWorld * lines.points[point].homogeneous();
    };
    std::vector<LineQuad> quads;
    quads.reserve(lines.segments.size());
    for (const auto& [first, second] : lines.segments) {
        Eigen::Vector4d a = project(first);
        Eigen::Vector4d b = project(second);
        if (clipToNear(a, b))
            quads.push_back(quadAround(a, b, transform, std::max(width, 1.0)));
    }
    return quads;
}

} // namespace tetra
