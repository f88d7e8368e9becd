// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/cpu/clipping.h"

#include <cmath>

namespace tetra {
namespace {

/// The signed distance from a cutting plane; inside is not negative.
double distanceFrom(std::size_t plane, const Eigen::Vector4d& p)
{
    switch (plane) {
    case 0: return p.z() + p.w();
    case 1: return guardBand * p.w() - p.x();
    case 2: return guardBand * p.w() + p.x();
    case 3: return guardBand * p.w() - p.y();
    default: return guardBand * p.w() + p.y();
    }
}

/// Always from the inner end, so that both triangles at an edge compute the same.
ClipVertex cutPoint(const ClipVertex& inner, double innerDistance, const ClipVertex& outer, double outerDistance)
{
    const double fraction = innerDistance / (innerDistance - outerDistance);
    const auto part = static_cast<float>(fraction);
    return {inner.position + fraction * (outer.position - inner.position),
            inner.normal + part * (outer.normal - inner.normal), inner.colour + part * (outer.colour - inner.colour)};
}

ClippedPolygon cutBy(std::size_t plane, const ClippedPolygon& polygon)
{
    ClippedPolygon result;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const ClipVertex& current = polygon.corners[i];
        const ClipVertex& next = polygon.corners[(i + 1) % polygon.count];
        const double here = distanceFrom(plane, current.position);
        const double there = distanceFrom(plane, next.position);
        if (here >= 0)
            result.corners[result.count++] = current;
        if (here >= 0 && there < 0)
            result.corners[result.count++] = cutPoint(current, here, next, there);
        else if (here < 0 && there >= 0)
            result.corners[result.count++] = cutPoint(next, there, current, here);
    }
    return result;
}

} // namespace

std::uint8_t outsideBits(const Eigen::Vector4d& p) noexcept
{
    if (!p.allFinite())
        return outside::notFinite;
    const double w = p.w();
    unsigned bits = 0;
    bits |= p.x() < -w ? outside::left : 0u;
    bits |= p.x() > w ? outside::right : 0u;
    bits |= p.y() < -w ? outside::below : 0u;
    bits |= p.y() > w ? outside::above : 0u;
    bits |= p.z() < -w || w <= 0 ? outside::near : 0u;
    bits |= std::abs(p.x()) > guardBand * w || std::abs(p.y()) > guardBand * w ? outside::guard : 0u;
    return static_cast<std::uint8_t>(bits);
}

ClippedPolygon clipTriangle(const std::array<ClipVertex, 3>& triangle)
{
    ClippedPolygon polygon;
    for (const ClipVertex& corner : triangle)
        polygon.corners[polygon.count++] = corner;
    for (std::size_t plane = 0; plane < 5 && polygon.count > 0; ++plane)
        polygon = cutBy(plane, polygon);
    return polygon;
}

} // namespace tetra
