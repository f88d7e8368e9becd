// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/transfer_plot.h"

#include "plugins/editors/transferfunction/editor_state.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr double grabDistance = 9;  // pixels
constexpr double curveDistance = 5; // pixels
constexpr double sideDistance = 4;  // pixels, from a step's value to the middle of a side's mark

double distanceBetween(QPointF from, QPointF to)
{
    return std::hypot(to.x() - from.x(), to.y() - from.y());
}

} // namespace

double TransferPlot::x(double value) const
{
    return xOfPlace(placeOnAxis(value, valueAxis));
}

double TransferPlot::xOfPlace(double place) const
{
    const double share = extent() > 0 ? (place - placeOnAxis(limits.least, valueAxis)) / extent() : 0.5;
    return area.left() + share * area.width();
}

double TransferPlot::y(double opacity) const
{
    const double part = (heightOf(opacity, axis) - heights.least) / (heights.largest - heights.least);
    return area.bottom() - part * area.height();
}

double TransferPlot::valueAt(double x) const
{
    const double share = std::clamp(shareAt(x), 0.0, 1.0);
    return std::clamp(between(share, share).least, limits.least, limits.largest);
}

double TransferPlot::shareAt(double x) const
{
    return area.width() > 0 ? (x - area.left()) / area.width() : 0.0;
}

TransferLimits TransferPlot::between(double from, double to) const
{
    const auto [first, last] = placesOnAxis(limits, valueAxis);
    return valuesOnAxis({std::lerp(first, last, from), std::lerp(first, last, to)}, valueAxis);
}

double TransferPlot::extent() const
{
    const auto [first, last] = placesOnAxis(limits, valueAxis);
    return last - first;
}

double TransferPlot::heightAt(double y) const
{
    const double part = area.height() > 0 ? (area.bottom() - y) / area.height() : 0.0;
    return std::clamp(std::lerp(heights.least, heights.largest, part), 0.0, 1.0);
}

double TransferPlot::opacityAt(double y) const
{
    return opacityAtHeight(heightAt(y), axis);
}

QPointF TransferPlot::place(const JoinedFunction& function, std::size_t point) const
{
    const TransferPoint& there = function.points[point];
    return {x(there.value) + sideOf(function, point) * sideDistance, y(there.opacity)};
}

std::optional<std::size_t> TransferPlot::pointAt(const JoinedFunction& function, QPointF pointer) const
{
    std::optional<std::size_t> nearest;
    double least = grabDistance;
    for (std::size_t i = 0; i < function.points.size(); ++i)
        if (const double distance = distanceBetween(place(function, i), pointer); distance <= least) {
            nearest = i;
            least = distance;
        }
    return nearest;
}

/// A steep part of the curve is as wide to the pointer as a flat one.
bool TransferPlot::isOnCurve(const TransferFunction& function, QPointF pointer) const
{
    if (function.opacities.empty() || !area.contains(pointer))
        return false;
    for (double aside = -curveDistance; aside <= curveDistance; ++aside) {
        const double near = pointer.x() + aside;
        if (distanceBetween({near, y(opacityOf(function, valueAt(near)))}, pointer) <= curveDistance)
            return true;
    }
    return false;
}

std::vector<std::size_t> TransferPlot::pointsIn(const JoinedFunction& function, const QRectF& rectangle) const
{
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < function.points.size(); ++i)
        if (rectangle.contains(place(function, i)))
            found.push_back(i);
    return found;
}

int sideOf(const JoinedFunction& function, std::size_t point)
{
    const auto& points = function.points;
    if (point + 1 < points.size() && points[point + 1].value == points[point].value)
        return -1;
    return point > 0 && points[point - 1].value == points[point].value ? 1 : 0;
}

} // namespace tetra
