// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/progressive/frame_cost.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

/// Seconds on one core of a few years ago, to begin with: only how they relate to each other matters later.
constexpr double orderPerCell = 2e-8;
constexpr double setUpPerCell = 4e-8;
constexpr double fillPerCell = 1e-7;
constexpr double fillPerFragment = 8e-9;
constexpr double restPerSample = 1.5e-8;
constexpr double restPerTriangle = 1e-7;
constexpr double smallestCost = 1e-4; ///< of any picture

/// One picture changes a factor by no more than this.
constexpr double largestCorrection = 8;
/// Shorter times are not measured, but noise.
constexpr double measurable = 1e-4;

struct CostParts {
    double order = 0;
    double setUp = 0;
    double fill = 0;
    double rest = 0;
    double sum() const { return order + setUp + fill + rest; }
};

CostParts costParts(const FrameCost& cost, const FrameWork& work)
{
    const double fragments = cost.fragmentsPerCrossing * work.samples * std::cbrt(work.tetrahedra);
    return {cost.order * orderPerCell * work.tetrahedra, cost.setUp * setUpPerCell * work.tetrahedra,
            cost.fill * (fillPerCell * work.tetrahedra + fillPerFragment * fragments),
            cost.rest * (smallestCost + restPerSample * work.samples + restPerTriangle * work.triangles)};
}

void learn(double& factor, double predicted, double measured)
{
    if (predicted <= 0 || measured < measurable)
        return;
    const double change = std::clamp(measured / predicted, 1 / largestCorrection, largestCorrection);
    factor *= std::sqrt(change);
}

} // namespace

double predictedSeconds(const FrameCost& cost, const FrameWork& work)
{
    return costParts(cost, work).sum();
}

FrameCost learned(const FrameCost& cost, const FrameWork& work, const RenderStatistics& statistics, double seconds)
{
    FrameCost result = cost;
    const double told = statistics.orderSeconds + statistics.setUpSeconds + statistics.fillSeconds;
    if (told <= 0) {
        const double before = predictedSeconds(cost, work);
        for (double* factor : {&result.order, &result.setUp, &result.fill, &result.rest})
            learn(*factor, before, seconds);
        return result;
    }
    const double crossings = work.samples * std::cbrt(work.tetrahedra);
    if (statistics.fragments > 0 && crossings > 0)
        learn(result.fragmentsPerCrossing, cost.fragmentsPerCrossing,
              static_cast<double>(statistics.fragments) / crossings);
    const CostParts parts = costParts(result, work);
    if (!statistics.orderReused)
        learn(result.order, parts.order, statistics.orderSeconds);
    learn(result.setUp, parts.setUp, statistics.setUpSeconds);
    learn(result.fill, parts.fill, statistics.fillSeconds);
    learn(result.rest, parts.rest, seconds - told);
    return result;
}

} // namespace tetra
