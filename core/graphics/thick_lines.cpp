// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/thick_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetra {
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
        return transform.clipFromWorld * lines.points[point].cast<double>().homogeneous();
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
