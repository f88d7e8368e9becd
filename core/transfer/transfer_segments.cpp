// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/transfer_segments.h"

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

} // namespace

std::vector<TransferSegment> transferSegments(const TransferFunction& function)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
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

} // namespace tetra
