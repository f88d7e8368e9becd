// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/editing/peak.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

/// With a point at the value, unless there is one.
TransferFunction withFoot(const TransferFunction& function, double value)
{
    const bool there = std::ranges::find(function.points, value, &TransferPoint::value) != function.points.end();
    const auto added = there ? std::nullopt : withPoint(function, value);
    return added ? added->function : function;
}

} // namespace

EditedSelection withPeak(const TransferFunction& function, const OpacityPeak& peak, const TransferLimits& limits)
{
    const bool inside = peak.value >= limits.least && peak.value <= limits.largest;
    const double left = std::max(peak.value - peak.width / 2, limits.least);
    const double right = std::min(peak.value + peak.width / 2, limits.largest);
    if (!inside || !(peak.width > 0) || !std::isfinite(peak.opacity) || !std::isfinite(right - left) || !(left < right))
        return {function, {}};
    EditedSelection edited{withFoot(withFoot(function, left), right), {}};
    auto& points = edited.function.points;
    TransferPoint top = points.front();
    top.value = peak.value;
    top.opacity = static_cast<float>(std::clamp(peak.opacity, 0.0, 1.0));
    top.group.reset();
    const TransferSample look = evaluateUnmasked(edited.function, peak.value);
    for (std::size_t channel = 0; channel < 3; ++channel)
        top.colour[channel] = std::clamp(static_cast<float>(look.colour[channel]), 0.0F, 1.0F);
    std::erase_if(points, [&](const TransferPoint& point) { return point.value > left && point.value < right; });
    if (peak.value == left || peak.value == right) {
        // Half a tent: the top is the foot at the end, on the inner side of a step that may be there.
        const auto at = peak.value == left ? std::ranges::upper_bound(points, left, {}, &TransferPoint::value) - 1
                                           : std::ranges::lower_bound(points, right, {}, &TransferPoint::value);
        at->opacity = top.opacity;
    } else {
        points.insert(std::ranges::upper_bound(points, left, {}, &TransferPoint::value), top);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool lowerSide = i + 1 < points.size() && points[i + 1].value == points[i].value;
        const bool upperSide = i > 0 && points[i - 1].value == points[i].value;
        const double value = points[i].value;
        if ((value > left && value < right) || (value == left && !lowerSide) || (value == right && !upperSide))
            edited.selection.push_back(i);
    }
    return edited;
}

} // namespace tetra
