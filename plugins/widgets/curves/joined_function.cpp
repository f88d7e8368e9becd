// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/curves/joined_function.h"

#include <algorithm>
#include <cmath>

namespace tetra {

JoinedFunction joined(const TransferFunction& function)
{
    return {transferPoints(function), function.unitDistance, function.mask};
}

TransferFunction separated(const JoinedFunction& function)
{
    TransferFunction result = transferFunctionFromPoints(function.points, function.unitDistance);
    result.mask = function.mask;
    return result;
}

std::optional<EditedPoint> withPoint(const JoinedFunction& function, double value)
{
    const auto same = std::ranges::count(function.points, value, &TransferPoint::value);
    if (!std::isfinite(value) || same >= 2)
        return std::nullopt;
    const TransferSample look = evaluateUnmasked(separated(function), value);
    TransferPoint added{value};
    for (std::size_t channel = 0; channel < 3; ++channel)
        added.colour[channel] = std::clamp(static_cast<float>(look.colour[channel]), 0.0F, 1.0F);
    added.opacity = static_cast<float>(-std::expm1(-look.extinction * function.unitDistance));
    EditedPoint edited{function, 0};
    const auto at = std::ranges::upper_bound(edited.function.points, value, {}, &TransferPoint::value);
    edited.point = static_cast<std::size_t>(at - edited.function.points.begin());
    edited.function.points.insert(at, added);
    return edited;
}

namespace {

auto place(std::size_t point)
{
    return static_cast<std::vector<TransferPoint>::difference_type>(point);
}

/// The other side of the step that the point is on.
std::optional<std::size_t> otherSide(const std::vector<TransferPoint>& points, std::size_t point)
{
    if (point > 0 && point < points.size() && points[point - 1].value == points[point].value)
        return point - 1;
    if (point + 1 < points.size() && points[point + 1].value == points[point].value)
        return point + 1;
    return std::nullopt;
}

} // namespace

bool isOnStep(const JoinedFunction& function, std::size_t point)
{
    return otherSide(function.points, point).has_value();
}

EditedPoint withStep(const JoinedFunction& function, std::size_t point)
{
    EditedPoint edited{function, point};
    if (point < function.points.size() && !isOnStep(function, point))
        edited.function.points.insert(edited.function.points.begin() + place(point), function.points[point]);
    return edited;
}

EditedPoint withoutStep(const JoinedFunction& function, std::size_t point)
{
    EditedPoint edited{function, point};
    if (const auto other = otherSide(function.points, point)) {
        edited.function.points.erase(edited.function.points.begin() + place(*other));
        edited.point = std::min(point, *other);
    }
    return edited;
}

} // namespace tetra
