// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/region_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

using Eigen::Vector3d;

constexpr double distanceRounding = 8 * std::numeric_limits<double>::epsilon();
/// What the separating axes and the distance from a tetrahedron may be wrong by, relative to the coordinates.
constexpr double testRounding = 1e-13;

// The order of the arguments of std::max below matters: what is not a number counts as 0, so as within.

double distance(const Box& box, const Vector3d& least, const Vector3d& largest)
{
    Vector3d gap;
    for (int axis = 0; axis < 3; ++axis)
        gap[axis] = std::max(std::max(0.0, box.least[axis] - largest[axis]), least[axis] - box.largest[axis]);
    return gap.norm();
}

double distance(const Sphere& sphere, const Vector3d& least, const Vector3d& largest)
{
    return std::max(0.0, distance(Box{sphere.centre, sphere.centre}, least, largest) - sphere.radius);
}

double farthest(const Box& box, const Hull& hull)
{
    Vector3d gap;
    for (int axis = 0; axis < 3; ++axis)
        gap[axis] = std::max(std::max(0.0, box.least[axis] - hull.least[axis]), hull.largest[axis] - box.largest[axis]);
    return gap.norm();
}

double farthest(const Sphere& sphere, const Hull& hull)
{
    return std::max(0.0, farthest(Box{sphere.centre, sphere.centre}, hull) - sphere.radius);
}

/// How far doubles may be off in normal . x - offset, anywhere in the hull, and the margin.
double uncertainty(const HalfSpace& half, const Hull& hull)
{
    const Vector3d size = hull.least.cwiseAbs().cwiseMax(hull.largest.cwiseAbs());
    return hull.margin + distanceRounding * (half.normal.cwiseAbs().dot(size) + std::abs(half.offset) + hull.margin);
}

double distance(const HalfSpace& half, const Hull& hull)
{
    double height = half.normal.dot(hull.corners[0]);
    for (int corner = 1; corner < 4; ++corner)
        height = std::min(height, half.normal.dot(hull.corners[corner]));
    return std::max(0.0, height - half.offset - uncertainty(half, hull));
}

double farthest(const HalfSpace& half, const Hull& hull)
{
    double height = half.normal.dot(hull.corners[0]);
    for (int corner = 1; corner < 4; ++corner)
        height = std::max(height, half.normal.dot(hull.corners[corner]));
    return std::max(0.0, height - half.offset + uncertainty(half, hull));
}

bool isWithin(const Box& box, const Vector3d& place)
{
    return (place.array() >= box.least.array()).all() && (place.array() <= box.largest.array()).all();
}

bool meetsHull(const Box& box, const Hull& hull)
{
    if ((hull.least.array() > box.largest.array()).any() || (hull.largest.array() < box.least.array()).any())
        return false;
    const Vector3d margin = Vector3d::Constant(hull.margin);
    const Box room{box.least - margin, box.largest + margin};
    for (const Vector3d& corner : hull.corners)
        if (isWithin(room, corner))
            return true;
    return tetrahedronMeetsBox(hull.corners, room, testRounding);
}

bool meetsHull(const Sphere& sphere, const Hull& hull)
{
    if (distance(sphere, hull.least, hull.largest) > 0)
        return false;
    const double size = hull.least.cwiseAbs().cwiseMax(hull.largest.cwiseAbs()).maxCoeff();
    const double room = sphere.radius + hull.margin + testRounding * (size + sphere.centre.cwiseAbs().maxCoeff());
    for (const Vector3d& corner : hull.corners)
        if ((corner - sphere.centre).squaredNorm() <= room * room)
            return true;
    return !(squaredDistance(hull.corners, sphere.centre) > room * room);
}

bool meetsHull(const HalfSpace& half, const Hull& hull)
{
    return !(distance(half, hull) > 0);
}

} // namespace

Hull::Hull(const Corners& hullCorners, double hullMargin)
    : corners(hullCorners), margin(hullMargin < 0 ? 0 : hullMargin),
      least(corners[0].cwiseMin(corners[1]).cwiseMin(corners[2].cwiseMin(corners[3]))),
      largest(corners[0].cwiseMax(corners[1]).cwiseMax(corners[2].cwiseMax(corners[3]))),
      finite(std::isfinite((corners[0] + corners[1] + corners[2] + corners[3]).sum() + margin))
{
    const Vector3d pad =
        (distanceRounding * least.cwiseAbs().cwiseMax(largest.cwiseAbs())).array() + margin * (1 + distanceRounding);
    least -= pad;
    largest += pad;
}

double distanceTo(const Region& region, const Eigen::Vector3d& place)
{
    if (const Box* const box = std::get_if<Box>(&region))
        return distance(*box, place, place);
    if (const Sphere* const sphere = std::get_if<Sphere>(&region))
        return distance(*sphere, place, place);
    const HalfSpace& half = *std::get_if<HalfSpace>(&region);
    return std::max(0.0, half.normal.dot(place) - half.offset);
}

double nearestDistance(const Region& region, const Hull& hull)
{
    if (const Box* const box = std::get_if<Box>(&region))
        return distance(*box, hull.least, hull.largest);
    if (const Sphere* const sphere = std::get_if<Sphere>(&region))
        return distance(*sphere, hull.least, hull.largest);
    return distance(*std::get_if<HalfSpace>(&region), hull);
}

double farthestDistance(const Region& region, const Hull& hull)
{
    if (const Box* const box = std::get_if<Box>(&region))
        return farthest(*box, hull);
    if (const Sphere* const sphere = std::get_if<Sphere>(&region))
        return farthest(*sphere, hull);
    return farthest(*std::get_if<HalfSpace>(&region), hull);
}

bool meets(const Region& region, const Hull& hull)
{
    if (const Box* const box = std::get_if<Box>(&region))
        return meetsHull(*box, hull);
    if (const Sphere* const sphere = std::get_if<Sphere>(&region))
        return meetsHull(*sphere, hull);
    return meetsHull(*std::get_if<HalfSpace>(&region), hull);
}

} // namespace tetra
