// SPDX-License-Identifier: GPL-3.0-or-later
#include <tan/transfer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace tetra {

namespace {

bool inUnitRange(float number)
{
    return number >= 0 && number <= 1;
}

Error wrongPoint(std::size_t index, const Message& what)
{
    return {ErrorKind::BadInput, Message::say("Point %1 of the transfer function %2", index + 1, what)};
}

TransferSample sampleAt(const TransferFunction& function, const TransferPoint& point)
{
    const auto& [red, green, blue] = point.colour;
    return {{red, green, blue}, extinctionOf(point.opacity, function.unitDistance)};
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
    const auto& points = function.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!std::isfinite(points[i].value))
            return wrongPoint(i, Message::say("has no finite value."));
        if (!std::ranges::all_of(points[i].colour, inUnitRange))
            return wrongPoint(i, Message::say("has a colour outside 0 to 1."));
        if (!inUnitRange(points[i].opacity))
            return wrongPoint(i, Message::say("has an opacity outside 0 to 1."));
        if (points[i].group && (*points[i].group < 0 || *points[i].group > largestTransferGroup))
            return wrongPoint(i, Message::say("is of a group that is none of 0 to 9."));
        if (i >= 1 && points[i].value < points[i - 1].value)
            return wrongPoint(
                i, Message::say("has a smaller value than the point before it. Put them in ascending order."));
        if (i >= 2 && points[i].value == points[i - 2].value)
            return wrongPoint(i, Message::say("is the third of its value. Two make a step; leave out those between."));
    }
    return function.mask ? checkMask(*function.mask) : Status{};
}

double extinctionOf(double opacity, double unitDistance) noexcept
{
    return -std::log1p(-std::min(opacity, largestOpacity)) / unitDistance;
}

TransferSample evaluate(const TransferFunction& function, double value)
{
    if (const auto& mask = function.mask; mask && !(value >= mask->least && value <= mask->largest))
        return {};
    return evaluateUnmasked(function, value);
}

TransferSample evaluateUnmasked(const TransferFunction& function, double value)
{
    const auto& points = function.points;
    if (points.empty() || std::isnan(value))
        return {};
    const auto above = std::ranges::upper_bound(points, value, {}, &TransferPoint::value);
    if (above == points.begin())
        return sampleAt(function, points.front());
    if (above == points.end())
        return sampleAt(function, points.back());
    const TransferSample low = sampleAt(function, above[-1]);
    const TransferSample high = sampleAt(function, *above);
    const double weight = (value - above[-1].value) / (above->value - above[-1].value);
    TransferSample result;
    for (std::size_t channel = 0; channel < 3; ++channel)
        result.colour[channel] = std::lerp(low.colour[channel], high.colour[channel], weight);
    result.extinction = std::lerp(low.extinction, high.extinction, weight);
    return result;
}

namespace {

TransferSample sampleAt(const TransferPoint& point, double unitDistance)
{
    const auto& [red, green, blue] = point.colour;
    return {{red, green, blue}, extinctionOf(point.opacity, unitDistance)};
}

TransferSample slope(const TransferSample& low, const TransferSample& high, double width)
{
    TransferSample result;
    for (std::size_t channel = 0; channel < 3; ++channel)
        result.colour[channel] = (high.colour[channel] - low.colour[channel]) / width;
    result.extinction = (high.extinction - low.extinction) / width;
    return result;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

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

std::vector<TransferSegment> unmaskedSegments(const TransferFunction& function)
{
    const auto& points = function.points;
    if (points.empty())
        return {{-infinity, infinity, 0, {}, {}}};
    const auto at = [&](std::size_t i) { return sampleAt(points[i], function.unitDistance); };

    std::vector<TransferSegment> segments;
    segments.push_back({-infinity, points.front().value, points.front().value, at(0), {}});
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double begin = points[i - 1].value;
        const double end = points[i].value;
        if (end > begin)
            segments.push_back({begin, end, begin, at(i - 1), slope(at(i - 1), at(i), end - begin)});
    }
    segments.push_back({points.back().value, infinity, points.back().value, at(points.size() - 1), {}});
    return segments;
}

} // namespace

std::vector<TransferSegment> transferSegments(const TransferFunction& function)
{
    std::vector<TransferSegment> segments = unmaskedSegments(function);
    return function.mask && !function.points.empty() ? masked(segments, *function.mask) : segments;
}

} // namespace tetra
