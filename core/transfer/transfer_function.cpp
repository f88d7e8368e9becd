// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/sort_unique.h"

#include <tan/transfer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tetra {

namespace {

bool inUnitRange(float number)
{
    return number >= 0 && number <= 1;
}

/// An error if the points of a curve are not in order; `wrong(i, what)` says so of one.
template <class Point, class Wrong> Status checkOrder(const std::vector<Point>& points, const Wrong& wrong)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& [value, look, group] = points[i];
        if (!std::isfinite(value))
            return wrong(i, Message::say("has no finite value."));
        if (group && (*group < 0 || *group > largestTransferGroup))
            return wrong(i, Message::say("has a group outside 0 to 9."));
        if (i >= 1 && value < points[i - 1].value)
            return wrong(i, Message::say("has a smaller value than the point before it. Put them in ascending order."));
        if (i >= 2 && value == points[i - 2].value)
            return wrong(i, Message::say("is the third at its value. Two make a step; leave out those between."));
    }
    return {};
}

Status checkColours(const std::vector<ColourPoint>& colours)
{
    const auto wrong = [](std::size_t index, const Message& what) {
        return Error{ErrorKind::BadInput, Message::say("Colour %1 of the transfer function %2", index + 1, what)};
    };
    for (std::size_t i = 0; i < colours.size(); ++i)
        if (!std::ranges::all_of(colours[i].colour, inUnitRange))
            return wrong(i, Message::say("has a channel outside 0 to 1."));
    return checkOrder(colours, wrong);
}

Status checkOpacities(const std::vector<OpacityPoint>& opacities)
{
    const auto wrong = [](std::size_t index, const Message& what) {
        return Error{ErrorKind::BadInput, Message::say("Opacity %1 of the transfer function %2", index + 1, what)};
    };
    for (std::size_t i = 0; i < opacities.size(); ++i)
        if (!inUnitRange(opacities[i].opacity))
            return wrong(i, Message::say("is outside 0 to 1."));
    return checkOrder(opacities, wrong);
}

} // namespace

Status checkMask(const TransferMask& mask)
{
    if (!std::isfinite(mask.least) || !std::isfinite(mask.largest) || !(mask.least <= mask.largest))
        return Error{ErrorKind::BadInput,
                     Message::say("The mask of a transfer function must be a range of finite values.")};
    return {};
}

Status checkTransferFunction(const TransferFunction& function)
{
    if (!(function.unitDistance > 0) || !std::isfinite(function.unitDistance))
        return Error{ErrorKind::BadInput,
                     Message::say("The unit distance of a transfer function must be a length above zero.")};
    if (const Status usable = checkColours(function.colours); !usable)
        return usable;
    if (const Status usable = checkOpacities(function.opacities); !usable)
        return usable;
    return function.mask ? checkMask(*function.mask) : Status{};
}

double extinctionOf(double opacity, double unitDistance) noexcept
{
    return -std::log1p(-std::min(opacity, largestOpacity)) / unitDistance;
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where a value lies on a curve: between one point and the next, which are the same beyond an end.
template <class Point> struct Stretch {
    const Point& low;
    const Point& high;

    double width() const { return high.value - low.value; }
    double share(double value) const { return width() > 0 ? (value - low.value) / width() : 0; }
};

/// Of the upper side at a step. O(log points).
template <class Point> Stretch<Point> stretchAt(const std::vector<Point>& points, double value)
{
    static const Point none{};
    if (points.empty())
        return {none, none};
    const auto above = std::ranges::upper_bound(points, value, {}, &Point::value);
    return {above == points.begin() ? *above : above[-1], above == points.end() ? above[-1] : *above};
}

std::array<double, 3> colourAt(const std::vector<ColourPoint>& colours, double value)
{
    const Stretch<ColourPoint> stretch = stretchAt(colours, value);
    std::array<double, 3> colour{};
    for (std::size_t channel = 0; channel < 3; ++channel)
        colour[channel] =
            std::lerp(double{stretch.low.colour[channel]}, double{stretch.high.colour[channel]}, stretch.share(value));
    return colour;
}

double extinctionAt(const std::vector<OpacityPoint>& opacities, double unitDistance, double value)
{
    const Stretch<OpacityPoint> stretch = stretchAt(opacities, value);
    return std::lerp(extinctionOf(stretch.low.opacity, unitDistance), extinctionOf(stretch.high.opacity, unitDistance),
                     stretch.share(value));
}

/// The values at which either curve has a point, ascending, each once.
std::vector<double> valuesOf(const TransferFunction& function)
{
    std::vector<double> values;
    for (const ColourPoint& point : function.colours)
        values.push_back(point.value);
    for (const OpacityPoint& point : function.opacities)
        values.push_back(point.value);
    sortUnique(values);
    return values;
}

} // namespace

std::vector<std::array<double, 2>> opacityKnots(const TransferFunction& function)
{
    std::vector<std::array<double, 2>> knots;
    const auto addEnd = [&](double value, bool before) {
        const Stretch<OpacityPoint> stretch = stretchAt(function.opacities, value);
        const double opacity =
            std::lerp(double{stretch.low.opacity}, double{stretch.high.opacity}, stretch.share(value));
        knots.push_back({value, before ? 0 : opacity});
        knots.push_back({value, before ? opacity : 0});
    };
    if (function.mask)
        addEnd(function.mask->least, true);
    for (const OpacityPoint& point : function.opacities)
        if (!function.mask || (function.mask->least < point.value && point.value < function.mask->largest))
            knots.push_back({point.value, double{point.opacity}});
    if (function.mask)
        addEnd(function.mask->largest, false);
    double largest = 0;
    for (const auto& [value, opacity] : knots)
        largest = std::max(largest, opacity);
    if (!(largest > 0))
        return {};
    for (auto& [value, opacity] : knots)
        opacity /= largest;
    return knots;
}

TransferSample evaluate(const TransferFunction& function, double value)
{
    if (const auto& mask = function.mask; mask && !(value >= mask->least && value <= mask->largest))
        return {};
    return evaluateUnmasked(function, value);
}

TransferSample evaluateUnmasked(const TransferFunction& function, double value)
{
    if (std::isnan(value))
        return {};
    return {colourAt(function.colours, value), extinctionAt(function.opacities, function.unitDistance, value)};
}

namespace {

/// How fast colour and extinction change above a value, up to the next point of either curve.
TransferSample slopeAbove(const TransferFunction& function, double value)
{
    TransferSample slope;
    if (const auto stretch = stretchAt(function.colours, value); stretch.width() > 0)
        for (std::size_t channel = 0; channel < 3; ++channel)
            slope.colour[channel] =
                (double{stretch.high.colour[channel]} - double{stretch.low.colour[channel]}) / stretch.width();
    if (const auto stretch = stretchAt(function.opacities, value); stretch.width() > 0)
        slope.extinction = (extinctionOf(stretch.high.opacity, function.unitDistance) -
                            extinctionOf(stretch.low.opacity, function.unitDistance)) /
                           stretch.width();
    return slope;
}

std::vector<TransferSegment> unmaskedSegments(const TransferFunction& function)
{
    const std::vector<double> values = valuesOf(function);
    std::vector<TransferSegment> segments;
    segments.push_back({-infinity, values.front(), values.front(), evaluateUnmasked(function, -infinity), {}});
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double end = i + 1 < values.size() ? values[i + 1] : infinity;
        segments.push_back(
            {values[i], end, values[i], evaluateUnmasked(function, values[i]), slopeAbove(function, values[i])});
    }
    return segments;
}

TransferSegment nothingSeen(double begin, double end)
{
    return {begin, end, std::isfinite(begin) ? begin : end, {}, {}};
}

/// The part of a segment within [begin, end). Its origin is at its beginning, if that is finite.
TransferSegment part(const TransferSegment& segment, double begin, double end)
{
    TransferSegment result = segment;
    result.begin = std::max(segment.begin, begin);
    result.end = std::min(segment.end, end);
    if (result.begin == segment.begin)
        return result;
    const double beyond = result.begin - segment.origin;
    result.origin = result.begin;
    for (std::size_t channel = 0; channel < 3; ++channel)
        result.atOrigin.colour[channel] += beyond * segment.perValue.colour[channel];
    // Rounding must not lead below zero.
    result.atOrigin.extinction = std::max(0.0, segment.atOrigin.extinction + beyond * segment.perValue.extinction);
    return result;
}

std::vector<TransferSegment> masked(const std::vector<TransferSegment>& segments, const TransferMask& mask)
{
    // Segments are half open, and the mask's largest value is shown.
    const double begin = mask.least, end = std::nextafter(mask.largest, infinity);
    std::vector<TransferSegment> result = {nothingSeen(-infinity, begin)};
    for (const TransferSegment& segment : segments)
        if (segment.begin < end && segment.end > begin)
            result.push_back(part(segment, begin, end));
    if (end < infinity)
        result.push_back(nothingSeen(end, infinity));
    return result;
}

} // namespace

std::vector<TransferSegment> transferSegments(const TransferFunction& function)
{
    if (function.opacities.empty())
        return {{-infinity, infinity, 0, {}, {}}};
    const std::vector<TransferSegment> segments = unmaskedSegments(function);
    return function.mask ? masked(segments, *function.mask) : segments;
}

TransferFunction transferFunctionFromPoints(std::span<const TransferPoint> points, double unitDistance)
{
    TransferFunction function;
    function.unitDistance = unitDistance;
    for (const TransferPoint& point : points) {
        function.colours.push_back({point.value, point.colour, point.group});
        function.opacities.push_back({point.value, point.opacity, point.group});
    }
    return function;
}

namespace {

/// The points of a curve at a value: none, one, or both sides of a step.
template <class Point> std::span<const Point> pointsAt(const std::vector<Point>& points, double value)
{
    return std::ranges::equal_range(points, value, {}, &Point::value);
}

/// The lower or the upper side of both curves at a value.
TransferPoint sideAt(const TransferFunction& function, double value, bool upper)
{
    TransferPoint side;
    side.value = value;
    if (const auto colours = pointsAt(function.colours, value); !colours.empty()) {
        const ColourPoint& point = upper ? colours.back() : colours.front();
        side.colour = point.colour;
        side.group = point.group;
    } else {
        std::ranges::transform(colourAt(function.colours, value), side.colour.begin(),
                               [](double channel) { return std::clamp(static_cast<float>(channel), 0.0F, 1.0F); });
    }
    if (const auto opacities = pointsAt(function.opacities, value); !opacities.empty()) {
        const OpacityPoint& point = upper ? opacities.back() : opacities.front();
        side.opacity = point.opacity;
        side.group = point.group;
    } else {
        side.opacity = static_cast<float>(-std::expm1(-extinctionAt(function.opacities, 1, value)));
    }
    return side;
}

} // namespace

std::vector<TransferPoint> transferPoints(const TransferFunction& function)
{
    std::vector<TransferPoint> points;
    for (const double value : valuesOf(function)) {
        if (pointsAt(function.colours, value).size() > 1 || pointsAt(function.opacities, value).size() > 1)
            points.push_back(sideAt(function, value, false));
        points.push_back(sideAt(function, value, true));
    }
    return points;
}

} // namespace tetra
