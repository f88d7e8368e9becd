// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view/blending.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {
namespace {

/// Opacities below this cannot be seen.
constexpr float leastShownOpacity = 0.002F;

template <class Number> Number blendOf(Number first, Number second, double part)
{
    return static_cast<Number>(first + (second - first) * part);
}

ColourPoint blendOf(const ColourPoint& first, const ColourPoint& second, double part)
{
    ColourPoint point = first;
    point.value = blendOf(first.value, second.value, part);
    for (std::size_t channel = 0; channel < 3; ++channel)
        point.colour[channel] = blendOf(first.colour[channel], second.colour[channel], part);
    return point;
}

OpacityPoint blendOf(const OpacityPoint& first, const OpacityPoint& second, double part)
{
    OpacityPoint point = first;
    point.value = blendOf(first.value, second.value, part);
    point.opacity = blendOf(first.opacity, second.opacity, part);
    return point;
}

/// Points that wander, each to the one of the same number.
template <class Point>
std::vector<Point> withMovedPoints(const std::vector<Point>& first, const std::vector<Point>& second, double part)
{
    std::vector<Point> result;
    for (std::size_t i = 0; i < first.size(); ++i)
        result.push_back(blendOf(first[i], second[i], part));
    return result;
}

template <class Point> bool hasStep(const std::vector<Point>& points, double value)
{
    return std::ranges::count(points, value, &Point::value) > 1;
}

/// Points at the values of both curves, each as `between(value)`; at a step of either one more that is what
/// `between(value)` is just below.
template <class Point, class Between> std::vector<Point>
withPointsOfBoth(const std::vector<Point>& first, const std::vector<Point>& second, const Between& between)
{
    std::vector<double> values;
    for (const auto* points : {&first, &second})
        for (const Point& point : *points)
            values.push_back(point.value);
    std::ranges::sort(values);
    const auto repeated = std::ranges::unique(values);
    values.erase(repeated.begin(), repeated.end());
    std::vector<Point> result;
    for (const double value : values) {
        if (hasStep(first, value) || hasStep(second, value)) {
            result.push_back(between(std::nextafter(value, -std::numeric_limits<double>::infinity())));
            result.back().value = value;
        }
        result.push_back(between(value));
    }
    return result;
}

/// A function between two.
class Blend {
public:
    Blend(const TransferFunction& first, const TransferFunction& second, double part)
        : first_(first), second_(second), part_(part),
          unitDistance_(blendOf(first.unitDistance, second.unitDistance, part))
    {
    }

    TransferFunction function() const
    {
        TransferFunction result;
        result.unitDistance = unitDistance_;
        const bool wander =
            first_.colours.size() == second_.colours.size() && first_.opacities.size() == second_.opacities.size();
        if (wander)
            result.mask = first_.mask;
        result.colours = wander ? withMovedPoints(first_.colours, second_.colours, part_)
                                : withPointsOfBoth(first_.colours, second_.colours,
                                                   [this](double value) { return colourAt(value); });
        result.opacities = wander ? withMovedPoints(first_.opacities, second_.opacities, part_)
                                  : withPointsOfBoth(first_.opacities, second_.opacities,
                                                     [this](double value) { return opacityAt(value); });
        return result;
    }

private:
    ColourPoint colourAt(double value) const
    {
        const TransferSample first = evaluateUnmasked(first_, value), second = evaluateUnmasked(second_, value);
        ColourPoint point{value};
        for (std::size_t channel = 0; channel < 3; ++channel)
            point.colour[channel] =
                static_cast<float>(std::clamp(blendOf(first.colour[channel], second.colour[channel], part_), 0.0, 1.0));
        return point;
    }
    OpacityPoint opacityAt(double value) const
    {
        const double extinction =
            blendOf(evaluate(first_, value).extinction, evaluate(second_, value).extinction, part_);
        return {value, static_cast<float>(std::clamp(-std::expm1(-extinction * unitDistance_), 0.0, 1.0))};
    }

    const TransferFunction& first_;
    const TransferFunction& second_;
    double part_;
    double unitDistance_;
};

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
    return Blend(first, second, part).function();
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
