// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/weighting.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <span>

namespace tetra {

namespace {

double fallenTo(double distance, double reach, double floor)
{
    if (distance >= reach)
        return distance > 0 ? floor : 1;
    return 1 - (1 - floor) * (distance / reach);
}

} // namespace

double Weighting::weight(const Eigen::Vector3d& position, double value) const
{
    if (empty())
        return 1;
    double largest = 0;
    for (const SpaceWeight& place : places)
        largest = std::max(largest, fallenTo(place.box.exteriorDistance(position), place.reach, place.floor));
    for (const ValueWeight& term : values)
        largest = std::max(largest, fallenTo(std::abs(value - term.value), term.reach, term.floor));
    return largest;
}

Result<std::vector<float>> pointWeights(const Weighting& weighting, const Dataset& dataset, const Progress& progress)
{
    constexpr std::uint64_t pointsAtOnce = 16384;
    std::vector<float> weights;
    if (weighting.empty())
        return weights;
    try {
        weights.resize(dataset.pointCount());
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, "Not enough memory for the weights of " +
                                                   std::to_string(dataset.pointCount()) +
                                                   " points. Build without weights, or close other programs."};
    }
    visitSampleType(dataset.values.type(), [&]<class T>() {
        const std::span<const T> values = dataset.values.as<T>();
        tbb::parallel_for(tbb::blocked_range<std::uint64_t>(0, weights.size(), pointsAtOnce), [&](const auto& range) {
            if (progress.cancelled())
                return;
            for (std::uint64_t point = range.begin(); point != range.end(); ++point)
                weights[point] =
                    static_cast<float>(weighting.weight(dataset.position(point), static_cast<double>(values[point])));
        });
    });
    if (progress.cancelled())
        return cancelledError("Weighting the points");
    return weights;
}

} // namespace tetra
