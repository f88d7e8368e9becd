// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/annotations/picture_projection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetra {
namespace {

/// Places nearer to the eye than this part of the target's distance count as beside it.
constexpr double nearest = 1e-3;

} // namespace

PictureProjection::PictureProjection(const Camera& camera, const Size& size)
    : axes_(viewMatrix(camera).topLeftCorner<3, 3>().transpose()), eye_(eyePosition(camera)),
      middle_(size.width / 2, size.height / 2), distance_(camera.distance), perspective_(camera.perspective)
{
    const double tangent = std::tan(camera.fieldOfView * (std::numbers::pi / 360));
    scale_ = std::max(1.0, std::min(size.width, size.height)) / 2 / tangent;
}

double PictureProjection::depthOf(const Eigen::Vector3d& place) const
{
    return towardsViewer().dot(eye_ - place);
}

double PictureProjection::unitsPerPixel(const Eigen::Vector3d& place) const
{
    return (perspective_ ? std::max(depthOf(place), nearest * distance_) : distance_) / scale_;
}

std::optional<Eigen::Vector2d> PictureProjection::pixelOf(const Eigen::Vector3d& place) const
{
    if (perspective_ && depthOf(place) < nearest * distance_)
        return std::nullopt;
    const Eigen::Vector3d fromEye = place - eye_;
    const double units = unitsPerPixel(place);
    return Eigen::Vector2d(middle_ + Eigen::Vector2d(right().dot(fromEye), -up().dot(fromEye)) / units);
}

Eigen::Vector2d PictureProjection::pixelsPerUnit(const Eigen::Vector3d& place, const Eigen::Vector3d& direction) const
{
    const double units = unitsPerPixel(place);
    const Eigen::Vector2d result = Eigen::Vector2d(right().dot(direction), -up().dot(direction)) / units;
    if (!perspective_)
        return result;
    // What comes nearer moves away from the middle.
    const double nearer = towardsViewer().dot(direction) / std::max(depthOf(place), nearest * distance_);
    return result + (pixelOf(place).value_or(middle_) - middle_) * nearer;
}

Eigen::Vector3d PictureProjection::movement(const Eigen::Vector3d& place, const Eigen::Vector2d& pixels) const
{
    return (right() * pixels.x() - up() * pixels.y()) * unitsPerPixel(place);
}

PickingRay PictureProjection::pickingRay(const Eigen::Vector2d& pixel) const
{
    const Eigen::Vector3d target = eye_ - distance_ * towardsViewer();
    const Eigen::Vector3d seen = target + movement(target, pixel - middle_);
    if (perspective_)
        return {eye_, (seen - eye_).normalized(), 0};
    return {seen, -towardsViewer()};
}

} // namespace tetra
