// SPDX-License-Identifier: GPL-3.0-or-later
#include <tan/transfer.h>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

/// The least distance of two points that are no step, as a part of the limits' extent: far above rounding, far below
/// what can be seen.
constexpr double leastDistance = 1e-5;

using Points = std::vector<TransferPoint>;

auto place(std::size_t point)
{
    return static_cast<Points::difference_type>(point);
}

/// The points of one value, [first, last].
struct Side {
    std::size_t first;
    std::size_t last;
};

Side sidesOf(const Points& points, std::size_t point)
{
    Side sides{point, point};
    if (point > 0 && points[point - 1].value == points[point].value)
        --sides.first;
    if (point + 1 < points.size() && points[point + 1].value == points[point].value)
        ++sides.last;
    return sides;
}

/// The nearest to `value` between the neighbours and within the limits; `present` if there is no room.
double nearestFree(const Points& points, const Side& sides, double value, const TransferLimits& limits)
{
    const double present = points[sides.first].value;
    const double distance = leastDistance * std::max(limits.largest - limits.least, 0.0);
    double least = limits.least;
    double largest = limits.largest;
    if (sides.first > 0)
        least = std::max(least, points[sides.first - 1].value + distance);
    if (sides.last + 1 < points.size())
        largest = std::min(largest, points[sides.last + 1].value - distance);
    return least <= largest && std::isfinite(value) ? std::clamp(value, least, largest) : present;
}

/// Of points of one value the first and the last: no more may have one.
void leaveStepsOnly(std::vector<TransferPoint>& points)
{
    std::vector<TransferPoint> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool between = i > 0 && i + 1 < points.size() && points[i - 1].value == points[i].value &&
                             points[i].value == points[i + 1].value;
        if (!between)
            kept.push_back(points[i]);
    }
    points = std::move(kept);
}

} // namespace

std::optional<EditedTransfer> withPoint(const TransferFunction& function, double value)
{
    const auto same = std::ranges::count(function.points, value, &TransferPoint::value);
    if (!std::isfinite(value) || same >= 2)
        return std::nullopt;
    const TransferSample look = evaluateUnmasked(function, value);
    TransferPoint added{value, {}, 0};
    for (std::size_t channel = 0; channel < 3; ++channel)
        added.colour[channel] = std::clamp(static_cast<float>(look.colour[channel]), 0.0F, 1.0F);
    added.opacity = static_cast<float>(-std::expm1(-look.extinction * function.unitDistance));
    if (function.points.empty())
        added.colour = {1, 1, 1};
    EditedTransfer edited{function, 0};
    const auto at = std::ranges::upper_bound(edited.function.points, value, {}, &TransferPoint::value);
    edited.point = static_cast<std::size_t>(at - edited.function.points.begin());
    edited.function.points.insert(at, added);
    return edited;
}

TransferFunction withoutPoint(const TransferFunction& function, std::size_t point)
{
    TransferFunction edited = function;
    if (point < edited.points.size())
        edited.points.erase(edited.points.begin() + place(point));
    return edited;
}

TransferFunction withMovedPoint(const TransferFunction& function, std::size_t point, double value, double opacity,
                                const TransferLimits& limits)
{
    TransferFunction edited = function;
    if (point >= edited.points.size())
        return edited;
    const Side sides = sidesOf(edited.points, point);
    const double moved = value == edited.points[point].value ? value : nearestFree(edited.points, sides, value, limits);
    for (std::size_t side = sides.first; side <= sides.last; ++side)
        edited.points[side].value = moved;
    if (std::isfinite(opacity))
        edited.points[point].opacity = static_cast<float>(std::clamp(opacity, 0.0, 1.0));
    return edited;
}

TransferFunction withColour(const TransferFunction& function, std::size_t point, const std::array<float, 3>& colour)
{
    TransferFunction edited = function;
    if (point < edited.points.size())
        edited.points[point].colour = colour;
    return edited;
}

TransferFunction withUnitDistance(const TransferFunction& function, double unitDistance)
{
    TransferFunction edited = function;
    if (unitDistance > 0 && std::isfinite(unitDistance))
        edited.unitDistance = unitDistance;
    return edited;
}

bool isOnStep(const TransferFunction& function, std::size_t point)
{
    if (point >= function.points.size())
        return false;
    const Side sides = sidesOf(function.points, point);
    return sides.first != sides.last;
}

EditedTransfer withStep(const TransferFunction& function, std::size_t point)
{
    EditedTransfer edited{function, point};
    if (point < function.points.size() && !isOnStep(function, point))
        edited.function.points.insert(edited.function.points.begin() + place(point), function.points[point]);
    return edited;
}

EditedTransfer withoutStep(const TransferFunction& function, std::size_t point)
{
    EditedTransfer edited{function, point};
    if (!isOnStep(function, point))
        return edited;
    const Side sides = sidesOf(function.points, point);
    edited.function = withoutPoint(function, point == sides.first ? sides.last : sides.first);
    edited.point = sides.first;
    return edited;
}

TransferFunction withScaledOpacity(const TransferFunction& function, double factor)
{
    TransferFunction edited = function;
    if (factor >= 0 && std::isfinite(factor))
        for (TransferPoint& point : edited.points)
            point.opacity = static_cast<float>(std::min(1.0, point.opacity * factor));
    return edited;
}

TransferFunction mirrored(const TransferFunction& function, const TransferLimits& limits)
{
    TransferFunction edited = function;
    for (TransferPoint& point : edited.points)
        point.value = limits.least + limits.largest - point.value;
    std::ranges::reverse(edited.points);
    leaveStepsOnly(edited.points);
    if (auto& mask = edited.mask) {
        const double sum = limits.least + limits.largest;
        mask = {sum - mask->largest, sum - mask->least};
    }
    return checkTransferFunction(edited) ? edited : function;
}

TransferFunction spreadOver(const TransferFunction& function, const TransferLimits& limits)
{
    TransferFunction edited = function;
    if (function.points.empty() || !(limits.least < limits.largest))
        return edited;
    const double first = function.points.front().value;
    const double extent = function.points.back().value - first;
    if (!(extent > 0) || !std::isfinite(extent))
        return edited;
    const auto spread = [&](double value) { return std::lerp(limits.least, limits.largest, (value - first) / extent); };
    for (TransferPoint& point : edited.points)
        point.value = spread(point.value);
    leaveStepsOnly(edited.points);
    if (auto& mask = edited.mask)
        mask = {spread(mask->least), spread(mask->largest)};
    return checkTransferFunction(edited) ? edited : function;
}

} // namespace tetra
