// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/region_handles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tetra {
namespace {

constexpr std::uint32_t circleSegments = 72;
/// A face is moved by its handle if a unit along its axis is seen as at least this part of a unit across the view.
constexpr double leastSeen = 0.2;

double lengthOf(QPointF vector)
{
    return std::hypot(vector.x(), vector.y());
}

/// How far along a direction a movement in the picture goes, in units of length; nowhere if the direction is not seen.
double along(const ViewProjection& projection, const Eigen::Vector3d& place, const Eigen::Vector3d& direction,
             QPointF pixels)
{
    const QPointF seen = projection.pixelsPerUnit(place, direction);
    const double whole = 1 / projection.unitsPerPixel(place);
    if (lengthOf(seen) < leastSeen * whole / 4)
        return 0;
    return QPointF::dotProduct(pixels, seen) / QPointF::dotProduct(seen, seen);
}

/// The axis along which a movement in the picture can best be followed.
int bestAxis(const ViewProjection& projection, const Eigen::Vector3d& place, QPointF pixels)
{
    std::array<double, 3> fit{};
    for (int axis = 0; axis < 3; ++axis) {
        const QPointF seen = projection.pixelsPerUnit(place, Eigen::Vector3d::Unit(axis));
        const double length = lengthOf(seen) * projection.unitsPerPixel(place);
        fit[static_cast<std::size_t>(axis)] =
            length < leastSeen ? 0 : std::abs(QPointF::dotProduct(pixels, seen)) / lengthOf(seen);
    }
    return static_cast<int>(std::ranges::max_element(fit) - fit.begin());
}

MovableRegion centreDragged(const RegionDrag& drag, QPointF pixels, const DragRule& rule)
{
    const Eigen::Vector3d centre = centreOf(drag.start);
    if (!rule.axis && !rule.restrained)
        return moved(drag.start, drag.projection.movement(centre, pixels));
    const int axis = rule.axis.value_or(bestAxis(drag.projection, centre, pixels));
    const Eigen::Vector3d direction = Eigen::Vector3d::Unit(axis);
    return moved(drag.start, direction * along(drag.projection, centre, direction, pixels));
}

MovableRegion faceDragged(const RegionDrag& drag, QPointF pixels, const DragRule& rule)
{
    Box box = std::get<Box>(drag.start);
    const int axis = drag.handle.axis;
    const double outwards =
        along(drag.projection, drag.handle.place, Eigen::Vector3d::Unit(axis) * drag.handle.side, pixels);
    const double size = box.largest[axis] - box.least[axis];
    const double growth = std::max(outwards, (rule.least - size) / (rule.restrained ? 2 : 1));
    if (drag.handle.side > 0 || rule.restrained)
        box.largest[axis] += growth;
    if (drag.handle.side < 0 || rule.restrained)
        box.least[axis] -= growth;
    return box;
}

MovableRegion radiusDragged(const RegionDrag& drag, QPointF pointer, const DragRule& rule)
{
    Sphere sphere = std::get<Sphere>(drag.start);
    const auto centre = drag.projection.pixelOf(sphere.centre);
    if (!centre)
        return sphere;
    const double farther = lengthOf(pointer - *centre) - lengthOf(drag.from - *centre);
    sphere.radius = std::max(rule.least, sphere.radius + farther * drag.projection.unitsPerPixel(sphere.centre));
    return sphere;
}

/// The circle around the centre that lies in the plane of these two.
void addCircle(LineSet& lines, const Sphere& sphere, const Eigen::Vector3d& one, const Eigen::Vector3d& other)
{
    const auto first = static_cast<std::uint32_t>(lines.points.size());
    for (std::uint32_t i = 0; i < circleSegments; ++i) {
        const double angle = 2 * std::numbers::pi * i / circleSegments;
        const Eigen::Vector3d point = sphere.centre + sphere.radius * (std::cos(angle) * one + std::sin(angle) * other);
        lines.points.push_back(point);
        lines.segments.push_back({first + i, first + (i + 1) % circleSegments});
    }
}

} // namespace

Eigen::Vector3d centreOf(const MovableRegion& region)
{
    if (const auto* sphere = std::get_if<Sphere>(&region))
        return sphere->centre;
    const Box& box = std::get<Box>(region);
    return (box.least + box.largest) / 2;
}

MovableRegion moved(const MovableRegion& region, const Eigen::Vector3d& by)
{
    if (const auto* sphere = std::get_if<Sphere>(&region))
        return Sphere{sphere->centre + by, sphere->radius};
    const Box& box = std::get<Box>(region);
    return Box{box.least + by, box.largest + by};
}

std::vector<RegionHandle> handlesOf(const MovableRegion& region, const ViewProjection& projection)
{
    using Kind = RegionHandle::Kind;
    std::vector<RegionHandle> handles{{Kind::Centre, 0, 1, centreOf(region)}};
    if (const auto* sphere = std::get_if<Sphere>(&region)) {
        for (const int axis : {0, 1})
            for (const double side : {-1.0, 1.0})
                handles.push_back(
                    {Kind::Radius, axis, side,
                     sphere->centre + side * sphere->radius * (axis == 0 ? projection.right() : projection.up())});
        return handles;
    }
    const Box& box = std::get<Box>(region);
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            Eigen::Vector3d place = centreOf(region);
            place[axis] = side < 0 ? box.least[axis] : box.largest[axis];
            const QPointF seen = projection.pixelsPerUnit(place, Eigen::Vector3d::Unit(axis));
            if (lengthOf(seen) * projection.unitsPerPixel(place) >= leastSeen)
                handles.push_back({Kind::Face, axis, side, place});
        }
    return handles;
}

std::optional<RegionHandle> handleAt(const std::vector<RegionHandle>& handles, const ViewProjection& projection,
                                     QPointF pixel, double reach)
{
    std::optional<RegionHandle> nearest;
    for (const RegionHandle& handle : handles) {
        const auto seen = projection.pixelOf(handle.place);
        if (!seen || lengthOf(*seen - pixel) > reach)
            continue;
        reach = lengthOf(*seen - pixel);
        nearest = handle;
    }
    return nearest;
}

LineSet outlineOf(const MovableRegion& region, const Colour& colour, float width)
{
    if (const Box* box = std::get_if<Box>(&region))
        return boxOutline({box->least, box->largest}, colour, width);
    LineSet lines;
    lines.colour = colour;
    lines.width = width;
    const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    for (int axis = 0; axis < 3; ++axis)
        addCircle(lines, std::get<Sphere>(region), axes.col(axis), axes.col((axis + 1) % 3));
    return lines;
}

MovableRegion RegionDrag::at(QPointF pointer, const DragRule& rule) const
{
    switch (handle.kind) {
    case RegionHandle::Kind::Face: return faceDragged(*this, pointer - from, rule);
    case RegionHandle::Kind::Radius: return radiusDragged(*this, pointer, rule);
    case RegionHandle::Kind::Centre: break;
    }
    return centreDragged(*this, pointer - from, rule);
}

} // namespace tetra
