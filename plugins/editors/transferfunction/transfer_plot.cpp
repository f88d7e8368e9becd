// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/transfer_plot.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr double grabDistance = 9; // pixels

} // namespace

double TransferPlot::x(double value) const
{
    const double extent = limits.largest - limits.least;
    return area.left() + (extent > 0 ? (value - limits.least) / extent : 0.5) * area.width();
}

double TransferPlot::y(double opacity) const
{
    return area.bottom() - std::sqrt(std::clamp(opacity, 0.0, 1.0)) * area.height();
}

double TransferPlot::valueAt(double x) const
{
    const double part = area.width() > 0 ? std::clamp((x - area.left()) / area.width(), 0.0, 1.0) : 0.0;
    return std::lerp(limits.least, limits.largest, part);
}

double TransferPlot::opacityAt(double y) const
{
    const double part = area.height() > 0 ? std::clamp((area.bottom() - y) / area.height(), 0.0, 1.0) : 0.0;
    return part * part;
}

QPointF TransferPlot::place(const TransferPoint& point) const
{
    return {x(point.value), y(point.opacity)};
}

std::optional<std::size_t> TransferPlot::pointAt(const TransferFunction& function, QPointF pointer) const
{
    std::optional<std::size_t> nearest;
    double least = grabDistance;
    for (std::size_t i = 0; i < function.points.size(); ++i) {
        const QPointF offset = place(function.points[i]) - pointer;
        if (const double distance = std::hypot(offset.x(), offset.y()); distance <= least) {
            nearest = i;
            least = distance;
        }
    }
    return nearest;
}

double opacityOf(const TransferFunction& function, double value)
{
    return -std::expm1(-evaluate(function, value).extinction * function.unitDistance);
}

} // namespace tetra
