// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/paraview/mask_steps.h"

#include "core/transfer/transfer_editing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetra {
namespace {

TransferFunction withPointAt(const TransferFunction& function, double value)
{
    const auto has = std::ranges::find(function.points, value, &TransferPoint::value) != function.points.end();
    const auto added = has ? std::nullopt : withPoint(function, value);
    return added ? added->function : function;
}

TransferPoint transparent(TransferPoint point, double value)
{
    point.value = value;
    point.opacity = 0;
    return point;
}

} // namespace

double leastApart(const TransferFunction& function)
{
    if (function.points.empty())
        return 0;
    const double first = function.points.front().value, last = function.points.back().value;
    return 1e-9 * (last > first ? last - first : std::max(1.0, std::abs(first)));
}

TransferFunction withMaskAsSteps(const TransferFunction& function)
{
    if (!function.mask || function.points.empty())
        return {function.points, function.unitDistance};
    const TransferMask mask = *function.mask;
    TransferFunction steps = withPointAt(withPointAt(function, mask.least), mask.largest);
    steps.mask.reset();
    auto& points = steps.points;
    const double apart = leastApart(steps);

    const auto above = std::ranges::upper_bound(points, mask.largest, {}, &TransferPoint::value);
    for (auto point = above; point != points.end(); ++point)
        point->opacity = 0;
    double hidden = mask.largest + apart;
    if (above != points.end())
        hidden = std::min(hidden, std::midpoint(mask.largest, above->value));
    points.insert(above, transparent(above[-1], hidden));

    const auto first = std::ranges::lower_bound(points, mask.least, {}, &TransferPoint::value);
    for (auto point = points.begin(); point != first; ++point)
        point->opacity = 0;
    if (std::ranges::count(points, mask.least, &TransferPoint::value) > 1)
        first->opacity = 0;
    else
        points.insert(first, transparent(*first, mask.least));
    return steps;
}

} // namespace tetra
