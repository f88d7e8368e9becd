// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/sight/sight_line.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr SightPart emptyPart{1, 0};

/// Where the line has normal . place >= offset.
SightPart partBeyond(const SightLine& line, const Eigen::Vector3d& normal, double offset)
{
    const double slope = normal.dot(line.direction);
    const double missing = offset - normal.dot(line.origin);
    if (slope == 0)
        return missing <= 0 ? SightPart{} : emptyPart;
    SightPart part;
    (slope > 0 ? part.from : part.to) = missing / slope;
    return part;
}

} // namespace

SightPart common(const SightPart& one, const SightPart& other)
{
    return {std::max(one.from, other.from), std::min(one.to, other.to)};
}

SightPart shownPart(const SightLine& line, std::span<const ClipPlane> planes)
{
    SightPart part;
    part.from = line.nearest;
    for (const ClipPlane& plane : planes)
        part = common(part, partBeyond(line, plane.normal, plane.offset));
    return part;
}

SightPart partWithin(const SightLine& line, const Box& box)
{
    SightPart part;
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d normal = Eigen::Vector3d::Unit(axis);
        part = common(part, partBeyond(line, normal, box.least[axis]));
        part = common(part, partBeyond(line, -normal, -box.largest[axis]));
    }
    return part;
}

SightPart partWithin(const SightLine& line, const Sphere& sphere)
{
    const Eigen::Vector3d toCentre = sphere.centre - line.origin;
    const double middle = toCentre.dot(line.direction);
    const double room = sphere.radius * sphere.radius - (toCentre - middle * line.direction).squaredNorm();
    if (!(room > 0))
        return emptyPart;
    return {middle - std::sqrt(room), middle + std::sqrt(room)};
}

} // namespace tetra
