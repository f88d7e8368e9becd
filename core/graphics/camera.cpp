// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetra {
namespace {

/// Distances beyond these would lose the matrices' precision.
constexpr double smallestDistance = 1e-30;
constexpr double largestDistance = 1e30;
/// The nearest that a perspective view shows, as a fraction of the farthest.
constexpr double nearestFraction = 1e-4;

double radians(double degrees)
{
    return degrees * (std::numbers::pi / 180);
}

/// The unit vectors of the eye: its columns are right, up and back (towards the viewer).
Eigen::Matrix3d eyeAxes(const Camera& camera)
{
    const double azimuth = radians(camera.azimuth);
    const double elevation = radians(camera.elevation);
    const Eigen::Vector3d right(std::cos(azimuth), std::sin(azimuth), 0);
    const Eigen::Vector3d back(std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                               std::sin(elevation));
    Eigen::Matrix3d axes;
    axes << right, back.cross(right), back;
    return axes;
}

double tangentOfHalfField(const Camera& camera)
{
    return std::tan(radians(std::clamp(camera.fieldOfView, 0.01, 179.0)) / 2);
}

struct DepthRange {
    double nearest;
    double farthest;
};

/// The distances from the eye, along its axis, between which the box lies, with a little room.
DepthRange depthRange(const Camera& camera, const Eigen::AlignedBox3d& bounds)
{
    DepthRange range{0, 2 * camera.distance};
    if (!bounds.isEmpty()) {
        const Eigen::Vector3d back = eyeAxes(camera).col(2);
        const double middle = back.dot(eyePosition(camera) - bounds.center());
        const double half = back.cwiseAbs().dot(bounds.sizes()) / 2;
        const double room = 0.01 * bounds.diagonal().norm() + 1e-6 * std::abs(middle);
        range = {middle - half - room, middle + half + room};
    }
    if (!camera.perspective)
        return range;
    if (range.farthest <= 0)
        return {nearestFraction * camera.distance, camera.distance};
    return {std::max(range.nearest, nearestFraction * range.farthest), range.farthest};
}

} // namespace

Camera fitted(const Camera& camera, const Eigen::AlignedBox3d& bounds)
{
    if (bounds.isEmpty())
        return camera;
    const double radius = bounds.diagonal().norm() / 2;
    Camera result = camera;
    result.target = bounds.center();
    result.distance = 1;
    return zoomed(result, (radius > 0 ? radius : 1) / std::sin(std::atan(tangentOfHalfField(camera))));
}

Camera turned(const Camera& camera, double azimuth, double elevation)
{
    Camera result = camera;
    result.azimuth = std::remainder(camera.azimuth + azimuth, 360.0);
    result.elevation = std::clamp(camera.elevation + elevation, -90.0, 90.0);
    return result;
}

Camera zoomed(const Camera& camera, double factor)
{
    Camera result = camera;
    if (factor > 0)
        result.distance = std::clamp(camera.distance * factor, smallestDistance, largestDistance);
    return result;
}

Camera panned(const Camera& camera, double right, double up)
{
    const double side = 2 * camera.distance * tangentOfHalfField(camera);
    Camera result = camera;
    result.target += eyeAxes(camera) * Eigen::Vector3d(right * side, up * side, 0);
    return result;
}

Eigen::Vector3d eyePosition(const Camera& camera)
{
    return camera.target + camera.distance * eyeAxes(camera).col(2);
}

Eigen::Matrix4d viewMatrix(const Camera& camera)
{
    const Eigen::Matrix3d rotation = eyeAxes(camera).transpose();
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topLeftCorner<3, 3>() = rotation;
    matrix.topRightCorner<3, 1>() = -rotation * eyePosition(camera);
    return matrix;
}

Eigen::Matrix4d projectionMatrix(const Camera& camera, double aspectRatio, const Eigen::AlignedBox3d& bounds)
{
    const auto [nearest, farthest] = depthRange(camera, bounds);
    const double depth = farthest - nearest;
    const double tangent = tangentOfHalfField(camera);
    const Eigen::Vector2d shape(std::min(1.0, 1 / aspectRatio), std::min(1.0, aspectRatio));

    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    if (camera.perspective) {
        matrix.diagonal() << shape / tangent, -(farthest + nearest) / depth, 0;
        matrix(2, 3) = -2 * farthest * nearest / depth;
        matrix(3, 2) = -1;
    } else {
        matrix.diagonal() << shape / (tangent * camera.distance), -2 / depth, 1;
        matrix(2, 3) = -(farthest + nearest) / depth;
    }
    return matrix;
}

} // namespace tetra
