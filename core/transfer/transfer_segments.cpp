// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/transfer_segments.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {
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
