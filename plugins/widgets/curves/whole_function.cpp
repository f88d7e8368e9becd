// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/curves/whole_function.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {
namespace {

/// A curve with all values elsewhere; in order, and of points of one value the first and the last.
template <class Point, class Where> std::vector<Point> movedPoints(const std::vector<Point>& points, const Where& where)
{
    std::vector<Point> moved;
    for (Point point : points) {
        point.value = where(point.value);
        const auto count = moved.size();
        if (count >= 2 && moved[count - 1].value == point.value && moved[count - 2].value == point.value)
            moved.pop_back();
        moved.push_back(point);
    }
    return moved;
}

/// All values elsewhere.
template <class Where> TransferFunction moved(const TransferFunction& function, const Where& where)
{
    TransferFunction edited{movedPoints(function.colours, where), movedPoints(function.opacities, where),
                            function.unitDistance};
    if (const auto& mask = function.mask)
        edited.mask = {where(mask->least), where(mask->largest)};
    return edited;
}

/// Values that are too large to be moved change nothing.
TransferFunction ifUsable(const TransferFunction& edited, const TransferFunction& function)
{
    return checkTransferFunction(edited) ? edited : function;
}

} // namespace

std::optional<TransferLimits> extentOf(const TransferFunction& function)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    TransferLimits extent{infinity, -infinity};
    const auto include = [&extent](const auto& points) {
        if (points.empty())
            return;
        extent.least = std::min(extent.least, points.front().value);
        extent.largest = std::max(extent.largest, points.back().value);
    };
    include(function.colours);
    include(function.opacities);
    return extent.least <= extent.largest ? std::optional(extent) : std::nullopt;
}

TransferFunction shifted(const TransferFunction& function, double by)
{
    return ifUsable(moved(function, [by](double value) { return value + by; }), function);
}

TransferFunction widened(const TransferFunction& function, double centre, double factor)
{
    if (!(factor > 0) || !std::isfinite(factor) || !std::isfinite(centre))
        return function;
    return ifUsable(moved(function, [=](double value) { return centre + (value - centre) * factor; }), function);
}

TransferFunction spreadOver(const TransferFunction& function, const TransferLimits& limits)
{
    const auto present = extentOf(function);
    if (!present || !(limits.least < limits.largest))
        return function;
    const double first = present->least, extent = present->largest - first;
    if (!(extent > 0) || !std::isfinite(extent))
        return function;
    const auto spread = [&](double value) { return std::lerp(limits.least, limits.largest, (value - first) / extent); };
    return ifUsable(moved(function, spread), function);
}

TransferFunction mirrored(const TransferFunction& function, const TransferLimits& limits)
{
    const double sum = limits.least + limits.largest;
    TransferFunction edited = moved(function, [sum](double value) { return sum - value; });
    std::ranges::reverse(edited.colours);
    std::ranges::reverse(edited.opacities);
    if (auto& mask = edited.mask)
        std::swap(mask->least, mask->largest);
    return ifUsable(edited, function);
}

TransferFunction withScaledOpacity(const TransferFunction& function, double factor)
{
    TransferFunction edited = function;
    if (factor >= 0 && std::isfinite(factor))
        for (OpacityPoint& point : edited.opacities)
            point.opacity = static_cast<float>(std::min(1.0, point.opacity * factor));
    return edited;
}

TransferFunction withUnitDistance(const TransferFunction& function, double unitDistance)
{
    TransferFunction edited = function;
    if (unitDistance > 0 && std::isfinite(unitDistance))
        edited.unitDistance = unitDistance;
    return edited;
}

TransferFunction withMask(const TransferFunction& function, const TransferMask& mask)
{
    TransferFunction edited = function;
    if (checkMask(mask))
        edited.mask = mask;
    return edited;
}

TransferFunction withoutMask(const TransferFunction& function)
{
    TransferFunction edited = function;
    edited.mask.reset();
    return edited;
}

} // namespace tetra
