// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/animation/blending.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

/// Opacities below this cannot be seen.
constexpr float leastShownOpacity = 0.002F;

template <class Number> Number blendOf(Number first, Number second, double part)
{
    return static_cast<Number>(first + (second - first) * part);
}

TransferFunction withMovedPoints(const TransferFunction& first, const TransferFunction& second, double part)
{
    TransferFunction result = first;
    result.unitDistance = blendOf(first.unitDistance, second.unitDistance, part);
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        TransferPoint& point = result.points[i];
        const TransferPoint& other = second.points[i];
        point.value = blendOf(point.value, other.value, part);
        point.opacity = blendOf(point.opacity, other.opacity, part);
        for (std::size_t channel = 0; channel < 3; ++channel)
            point.colour[channel] = blendOf(point.colour[channel], other.colour[channel], part);
    }
    return result;
}

/// The values of the points of both, each once.
std::vector<double> valuesOf(const TransferFunction& first, const TransferFunction& second)
{
    std::vector<double> values;
    for (const TransferFunction* function : {&first, &second})
        for (const TransferPoint& point : function->points)
            values.push_back(point.value);
    std::ranges::sort(values);
    const auto repeated = std::ranges::unique(values);
    values.erase(repeated.begin(), repeated.end());
    return values;
}

bool hasStep(const TransferFunction& function, double value)
{
    return std::ranges::count(function.points, value, &TransferPoint::value) > 1;
}

/// What a value looks like seen from below: where there is a step its lower side.
TransferSample sampleBelow(const TransferFunction& function, double value)
{
    if (!hasStep(function, value))
        return evaluate(function, value);
    const auto lower = std::ranges::find(function.points, value, &TransferPoint::value);
    return {{lower->colour[0], lower->colour[1], lower->colour[2]},
            extinctionOf(lower->opacity, function.unitDistance)};
}

TransferPoint pointBetween(double value, const TransferSample& first, const TransferSample& second, double part,
                           double unitDistance)
{
    TransferPoint point;
    point.value = value;
    for (std::size_t channel = 0; channel < 3; ++channel)
        point.colour[channel] =
            static_cast<float>(std::clamp(blendOf(first.colour[channel], second.colour[channel], part), 0.0, 1.0));
    const double extinction = blendOf(first.extinction, second.extinction, part);
    point.opacity = static_cast<float>(std::clamp(-std::expm1(-extinction * unitDistance), 0.0, 1.0));
    return point;
}

TransferFunction withPointsOfBoth(const TransferFunction& first, const TransferFunction& second, double part)
{
    TransferFunction result;
    result.unitDistance = blendOf(first.unitDistance, second.unitDistance, part);
    for (const double value : valuesOf(first, second)) {
        if (hasStep(first, value) || hasStep(second, value))
            result.points.push_back(
                pointBetween(value, sampleBelow(first, value), sampleBelow(second, value), part, result.unitDistance));
        result.points.push_back(
            pointBetween(value, evaluate(first, value), evaluate(second, value), part, result.unitDistance));
    }
    return result;
}

float seenOpacity(const Isovalue* isovalue)
{
    return isovalue != nullptr && isovalue->visible ? isovalue->opacity : 0;
}

Isovalue isovalueBetween(const Isovalue& first, const Isovalue& second, double part)
{
    Isovalue result = first;
    result.value = blendOf(first.value, second.value, part);
    result.red = blendOf(first.red, second.red, part);
    result.green = blendOf(first.green, second.green, part);
    result.blue = blendOf(first.blue, second.blue, part);
    return result;
}

} // namespace

TransferFunction blended(const TransferFunction& first, const TransferFunction& second, double part)
{
    if (part <= 0 || first == second)
        return first;
    if (part >= 1)
        return second;
    if (first.points.size() == second.points.size())
        return withMovedPoints(first, second, part);
    return withPointsOfBoth(first, second, part);
}

std::vector<Isovalue> blended(const std::vector<Isovalue>& first, const std::vector<Isovalue>& second, double part)
{
    if (part <= 0 || first == second)
        return first;
    if (part >= 1)
        return second;
    std::vector<Isovalue> result;
    for (std::size_t i = 0; i < std::max(first.size(), second.size()); ++i) {
        const Isovalue* one = i < first.size() ? &first[i] : nullptr;
        const Isovalue* other = i < second.size() ? &second[i] : nullptr;
        const float oneOpacity = seenOpacity(one);
        const float otherOpacity = seenOpacity(other);
        const Isovalue& from = oneOpacity > 0 || other == nullptr ? *one : *other;
        const Isovalue& to = otherOpacity > 0 || one == nullptr ? *other : *one;
        Isovalue isovalue = isovalueBetween(from, to, part);
        isovalue.opacity = blendOf(oneOpacity, otherOpacity, part);
        isovalue.visible = isovalue.opacity >= leastShownOpacity;
        isovalue.opacity = std::max(isovalue.opacity, leastShownOpacity);
        result.push_back(isovalue);
    }
    return result;
}

} // namespace tetra
