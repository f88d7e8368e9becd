// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/scaled_segments.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

/// Beyond all scaled values, but far from overflow.
constexpr double farAway = 1e30;

ScaledSegment scaled(const TransferSegment& segment, const ScaledSegments& all, double unit)
{
    const auto scaledValue = [&](double value) {
        return static_cast<float>(std::clamp((value - all.smallest) * all.perValue, -farAway, farAway));
    };
    ScaledSegment result;
    result.begin = scaledValue(segment.begin);
    result.end = scaledValue(segment.end);
    result.origin = scaledValue(segment.origin);
    result.halfExtinction = static_cast<float>(segment.atOrigin.extinction * unit / 2);
    result.halfExtinctionPerValue = static_cast<float>(segment.perValue.extinction / all.perValue * unit / 2);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        result.colour[channel] = static_cast<float>(segment.atOrigin.colour[channel]);
        result.colourPerValue[channel] = static_cast<float>(segment.perValue.colour[channel] / all.perValue);
    }
    const double width = std::isfinite(segment.end - segment.begin) ? segment.end - segment.begin : 0;
    const double atEnd = segment.atOrigin.extinction + width * segment.perValue.extinction;
    result.largestExtinction = static_cast<float>(std::max(segment.atOrigin.extinction, atEnd) * unit);
    result.transparent = segment.transparent();
    return result;
}

} // namespace

ScaledSegments scaleSegments(std::span<const TransferSegment> segments, double unit)
{
    ScaledSegments result;
    for (std::size_t i = 1; i < segments.size(); ++i)
        result.knots.push_back(segments[i].begin);
    if (!result.knots.empty())
        result.smallest = result.knots.front();
    if (result.knots.size() > 1)
        result.perValue = 1 / (result.knots.back() - result.knots.front());
    for (const TransferSegment& segment : segments)
        result.segments.push_back(scaled(segment, result, unit));
    return result;
}

} // namespace tetra
