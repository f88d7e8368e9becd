// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/sort_unique.h"

#include <tan/transfer.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace tetra {

namespace {

/// Over values in [0, 1]; spreads them over the range.
TransferFunction spread(std::span<const TransferPoint> points, double smallest, double largest, double unitDistance)
{
    if (!(smallest < largest) || !std::isfinite(smallest) || !std::isfinite(largest)) {
        TransferPoint middle = points[points.size() / 2];
        middle.value = std::isfinite(smallest) ? smallest : 0;
        return transferFunctionFromPoints({middle}, unitDistance);
    }
    std::vector<TransferPoint> spreadPoints(points.begin(), points.end());
    for (TransferPoint& point : spreadPoints)
        point.value = std::lerp(smallest, largest, point.value);
    return transferFunctionFromPoints(spreadPoints, unitDistance);
}

} // namespace

TransferFunction sequentialTransferFunction(double smallest, double largest, double unitDistance)
{
    constexpr TransferPoint viridis[] = {
        {0, {0.267f, 0.005f, 0.329f}, 0},        {0.125, {0.278f, 0.176f, 0.482f}, 0.01f},
        {0.25, {0.231f, 0.322f, 0.545f}, 0.03f}, {0.375, {0.173f, 0.447f, 0.557f}, 0.06f},
        {0.5, {0.129f, 0.569f, 0.549f}, 0.1f},   {0.625, {0.157f, 0.682f, 0.502f}, 0.18f},
        {0.75, {0.361f, 0.784f, 0.388f}, 0.3f},  {0.875, {0.675f, 0.863f, 0.196f}, 0.5f},
        {1, {0.992f, 0.906f, 0.145f}, 0.8f},
    };
    return spread(viridis, smallest, largest, unitDistance);
}

TransferFunction divergingTransferFunction(double smallest, double largest, double unitDistance)
{
    constexpr TransferPoint blueToOrange[] = {
        {0, {0.000f, 0.447f, 0.698f}, 0.6f},     {0.25, {0.400f, 0.680f, 0.850f}, 0.15f},
        {0.45, {0.950f, 0.950f, 0.930f}, 0.01f}, {0.5, {0.960f, 0.950f, 0.920f}, 0},
        {0.55, {0.970f, 0.940f, 0.900f}, 0.01f}, {0.75, {0.930f, 0.630f, 0.380f}, 0.15f},
        {1, {0.835f, 0.369f, 0.000f}, 0.6f},
    };
    return spread(blueToOrange, smallest, largest, unitDistance);
}

namespace {

/// Colours of volumes for values in [0, 1]: from blue over cream to orange, none of them dark, as what is translucent
/// takes the darkness of the ground.
TransferFunction volumeColours()
{
    constexpr TransferPoint blueToOrange[] = {
        {0, {0.36f, 0.60f, 0.95f}, 0},    {0.25, {0.52f, 0.80f, 0.97f}, 0}, {0.5, {0.95f, 0.95f, 0.90f}, 0},
        {0.75, {1.00f, 0.80f, 0.48f}, 0}, {1, {1.00f, 0.54f, 0.16f}, 0},
    };
    return spread(blueToOrange, 0, 1, 1);
}

constexpr std::size_t intervals = 16;       ///< between the points
constexpr double pathLength = 20;           ///< in unit distances: half of the diagonal
constexpr double depthOfCloud = 7;          ///< the mean optical depth of such a path
constexpr double depthOfObject = 14;        ///< the same in a background: surfaces before what is inside
constexpr double mostOpaque = 0.9;          ///< of a unit distance
constexpr double dominating = 2.5;          ///< times its share if all values were equally frequent
constexpr double leastWeightOfSmall = 0.15; ///< of the smallest value against the largest

double positionOf(std::size_t index)
{
    return static_cast<double>(index) / static_cast<double>(intervals);
}

/// The share of the volume near each point against what it would be if all values were equally frequent: the mean over
/// an interval to both sides, weighted by nearness.
std::vector<double> frequencies(const ValueHistogram& volumes)
{
    const double parts = static_cast<double>(volumes.counts.size());
    std::vector<double> sums(intervals + 1), weights(intervals + 1);
    for (std::size_t part = 0; part < volumes.counts.size(); ++part) {
        const double place = (static_cast<double>(part) + 0.5) / parts * static_cast<double>(intervals);
        const auto below = static_cast<std::size_t>(place);
        const double nearness = place - static_cast<double>(below);
        for (const auto& [point, weight] : {std::pair(below, 1 - nearness), std::pair(below + 1, nearness)}) {
            sums[point] += weight * static_cast<double>(volumes.counts[part]);
            weights[point] += weight;
        }
    }
    const double mean =
        static_cast<double>(std::reduce(volumes.counts.begin(), volumes.counts.end(), std::uint64_t(0))) / parts;
    for (std::size_t point = 0; point < sums.size(); ++point)
        sums[point] = weights[point] > 0 ? sums[point] / (weights[point] * mean) : 0;
    return sums;
}

double rarity(double frequency)
{
    return 1 / (1 + frequency * frequency);
}

/// How opaque the points are against each other.
std::vector<double> valueWeights(const std::vector<double>& frequency)
{
    const double most = std::ranges::max(frequency);
    const double hidden = most > dominating ? rarity(most) : 0;
    std::vector<double> weights;
    for (std::size_t point = 0; point < frequency.size(); ++point)
        weights.push_back(std::max(rarity(frequency[point]) - hidden, 0.0) *
                          std::lerp(leastWeightOfSmall, 1.0, positionOf(point)));
    return weights;
}

double extinctionAt(double weight, double scale)
{
    return std::min(weight * scale, extinctionOf(mostOpaque, 1));
}

/// The part of the volume that is seen at all: what little of it is weighs little.
double seenShare(const std::vector<double>& weights, const std::vector<double>& frequency)
{
    const double most = std::ranges::max(weights);
    double seen = 0;
    for (std::size_t point = 0; point < weights.size(); ++point)
        seen += most > 0 ? frequency[point] * std::min(1.0, 4 * weights[point] / most) : 0;
    return seen / std::reduce(frequency.begin(), frequency.end());
}

/// The factor at which a path of mean length through the domain has the wanted optical depth, as far as it can be had.
/// Where only a part of the domain is seen, a path meets as much less of it.
double scaleFor(const std::vector<double>& weights, const std::vector<double>& frequency, double depthOfPath)
{
    const double total = std::reduce(frequency.begin(), frequency.end());
    const double wanted = depthOfPath * seenShare(weights, frequency);
    const auto depth = [&](double scale) {
        double sum = 0;
        for (std::size_t point = 0; point < weights.size(); ++point)
            sum += frequency[point] / total * extinctionAt(weights[point], scale);
        return sum * pathLength;
    };
    double low = 0, high = 1e3;
    for (int turn = 0; turn < 60; ++turn) {
        const double middle = (low + high) / 2;
        (depth(middle) < wanted ? low : high) = middle;
    }
    return high;
}

/// Where each point lies in the colours, [0, 1]: half by its value, half by how much of what is seen lies below.
std::vector<double> places(const std::vector<double>& weights, const std::vector<double>& frequency)
{
    std::vector<double> seen(weights.size());
    for (std::size_t point = 1; point < weights.size(); ++point)
        seen[point] = seen[point - 1] + (weights[point - 1] * frequency[point - 1] + weights[point] * frequency[point]);
    for (std::size_t point = 0; point < weights.size(); ++point) {
        const double rank = seen.back() > 0 ? seen[point] / seen.back() : positionOf(point);
        seen[point] = (rank + positionOf(point)) / 2;
    }
    return seen;
}

constexpr double leastFade = 1.0 / 32;   ///< of the range, over which opacities rise beside the background
constexpr double seenAtLeast = 1.0 / 8;  ///< of the range, whatever the error
constexpr double errorMargin = 1.0 / 20; ///< of the error, for what rounding adds to it

/// What is transparent, and the width over which opacities rise beside it.
struct ClearedValues {
    double least;
    double largest;
    double fade;

    /// The factor of the extinction.
    double at(double value) const
    {
        const double distance = std::max(least - value, value - largest);
        return fade > 0 ? std::clamp(distance / fade, 0.0, 1.0) : distance > 0 ? 1 : 0;
    }
};

/// What an error takes for the background. What little of the range is left between that and the nearer end is no
/// better than the background; on the other side enough is left to see something.
ClearedValues clearedValues(const BackgroundValues& background, const ValueHistogram& volumes, double error)
{
    const double extent = volumes.largest - volumes.least;
    const double reach = error * (1 + errorMargin);
    const double fade = std::max(reach, leastFade * extent);
    const double seen = seenAtLeast * extent;
    double least = background.least - reach;
    double largest = background.largest + reach;
    if (background.commonest - volumes.least <= volumes.largest - background.commonest) {
        least = least - volumes.least <= fade ? volumes.least : least;
        largest = std::min(largest, volumes.largest - seen);
        return {least, largest, std::min(fade, volumes.largest - largest)};
    }
    largest = volumes.largest - largest <= fade ? volumes.largest : largest;
    least = std::max(least, volumes.least + seen);
    return {least, largest, std::min(fade, least - volumes.least)};
}

/// The function with nothing of these values, and no more of any other than before.
TransferFunction cleared(const TransferFunction& function, const ClearedValues& values)
{
    std::vector<double> knots;
    for (const OpacityPoint& point : function.opacities)
        knots.push_back(point.value);
    const double first = knots.front(), last = knots.back();
    for (const double knot : {values.least - values.fade, values.least, values.largest, values.largest + values.fade})
        if (knot > first && knot < last)
            knots.push_back(knot);
    sortUnique(knots);
    TransferFunction result = function;
    result.opacities.clear();
    for (const double knot : knots) {
        const bool isWithin = knot > values.least && knot < values.largest && knot > first && knot < last;
        const double extinction = evaluate(function, knot).extinction * values.at(knot);
        if (!isWithin)
            result.opacities.push_back(
                {knot, static_cast<float>(-std::expm1(-extinction * function.unitDistance)), {}});
    }
    return result;
}

} // namespace

TransferFunction fittedTransferFunction(const ValueHistogram& volumes, double unitDistance, double error)
{
    if (volumes.highest() == 0 || !(volumes.least < volumes.largest))
        return sequentialTransferFunction(volumes.least, volumes.largest, unitDistance);
    const std::vector<double> frequency = frequencies(volumes);
    const std::vector<double> weights = valueWeights(frequency);
    const auto background = backgroundValues(volumes);
    const double scale = scaleFor(weights, frequency, background ? depthOfObject : depthOfCloud);
    const std::vector<double> place = places(weights, frequency);
    const TransferFunction colours = volumeColours();
    std::vector<TransferPoint> points(weights.size());
    for (std::size_t point = 0; point < points.size(); ++point) {
        const TransferSample look = evaluate(colours, place[point]);
        points[point].value = std::lerp(volumes.least, volumes.largest, positionOf(point));
        for (std::size_t channel = 0; channel < 3; ++channel)
            points[point].colour[channel] = static_cast<float>(std::clamp(look.colour[channel], 0.0, 1.0));
        points[point].opacity = static_cast<float>(-std::expm1(-extinctionAt(weights[point], scale)));
    }
    const TransferFunction function = transferFunctionFromPoints(points, unitDistance);
    return background ? cleared(function, clearedValues(*background, volumes, error)) : function;
}

} // namespace tetra
