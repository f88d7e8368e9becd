// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/scene_pick.h"

#include <limits>

namespace tetra {
namespace {

/// The parameter at which the line passes through the triangle, from either side (Möller and Trumbore).
std::optional<double> crossing(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                               const std::array<Eigen::Vector3d, 3>& corners)
{
    const Eigen::Vector3d one = corners[1] - corners[0];
    const Eigen::Vector3d other = corners[2] - corners[0];
    const Eigen::Vector3d across = direction.cross(other);
    const double volume = one.dot(across);
    if (volume == 0)
        return std::nullopt;
    const Eigen::Vector3d from = origin - corners[0];
    const double u = from.dot(across) / volume;
    const Eigen::Vector3d beside = from.cross(one);
    const double v = direction.dot(beside) / volume;
    if (u < 0 || v < 0 || u + v > 1)
        return std::nullopt;
    return other.dot(beside) / volume;
}

} // namespace

std::optional<Eigen::Vector3d> placeSeenAt(const Scene& scene, const PictureProjection& projection, QPointF pixel)
{
    const auto [origin, direction] = projection.sightLine(pixel);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Surface& surface : scene.surfaces)
        for (const auto& triangle : surface.mesh->triangles) {
            const auto corner = [&](std::size_t i) {
                return Eigen::Vector3d(surface.mesh->positions[triangle[i]].cast<double>());
            };
            const auto at = crossing(origin, direction, {corner(0), corner(1), corner(2)});
            if (at && *at < nearest && (!projection.perspective() || *at > 0))
                nearest = *at;
        }
    if (nearest == std::numeric_limits<double>::infinity())
        return std::nullopt;
    return origin + nearest * direction;
}

} // namespace tetra
