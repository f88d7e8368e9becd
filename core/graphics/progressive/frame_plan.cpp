// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/progressive/frame_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tetra {
namespace {

constexpr std::uint64_t coarsest = 2000; ///< tetrahedra; fewer save no time worth having
constexpr std::array reductions{1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0};
/// A plan is kept while it takes no more than this part of the budget ...
constexpr double keptAbove = 1.15;
/// ... and a better one is taken up if it takes no more than this.
constexpr double takenBelow = 0.7;
/// A picture that comes within this needs no quicker one before it.
constexpr double quickEnough = 0.12;
/// A step takes at most this part of the time of the next one.
constexpr double worthwhile = 0.35;

/// How much coarser than the best plan, in octaves of what is seen: pixels and cells count alike.
double loss(std::span<const FrameLevel> levels, const FramePlan& plan)
{
    const double cells = std::max(levels[0].tetrahedra, 1.0) / std::max(levels[plan.level].tetrahedra, 1.0);
    return std::log2(plan.reduction) + std::log2(cells) / 3;
}

FrameWork workOf(const FrameLevel& level, double samples)
{
    return {level.isVolume ? level.tetrahedra : 0, level.triangles, samples};
}

} // namespace

std::vector<std::uint64_t> coarserMeshes(std::uint64_t whole)
{
    std::vector<std::uint64_t> sizes;
    for (std::uint64_t size = whole / 4; size >= coarsest; size /= 4)
        sizes.push_back(size);
    return sizes;
}

double predictedSeconds(const FrameLevel& level, double pixels, double reduction)
{
    return predictedSeconds(level.cost, workOf(level, pixels / (reduction * reduction)));
}

FramePlan chooseFrame(std::span<const FrameLevel> levels, double pixels, double budget,
                      const std::optional<FramePlan>& last)
{
    const auto seconds = [&](const FramePlan& plan) {
        return predictedSeconds(levels[plan.level], pixels, plan.reduction);
    };
    constexpr double none = std::numeric_limits<double>::infinity();
    const FramePlan kept = last.value_or(FramePlan{levels.size(), 1});
    const bool keepsBudget = kept.level < levels.size() && seconds(kept) <= keptAbove * budget;
    const double allowed = keepsBudget ? takenBelow * budget : budget;
    double leastLoss = keepsBudget ? loss(levels, kept) : none;
    FramePlan best = kept;
    FramePlan quickest;
    for (std::size_t level = 0; level < levels.size(); ++level) {
        for (const double reduction : reductions) {
            const FramePlan plan{level, reduction};
            if (seconds(plan) < seconds(quickest))
                quickest = plan;
            if (seconds(plan) <= allowed && loss(levels, plan) < leastLoss) {
                best = plan;
                leastLoss = loss(levels, plan);
            }
        }
    }
    return leastLoss < none ? best : quickest;
}

std::vector<RefinementStep> refinementSteps(const FrameLevel& finest, double pixels, int samplesPerAxis)
{
    const auto seconds = [&](const RefinementStep& step) {
        return predictedSeconds(finest, pixels, step.reduction / step.samplesPerAxis);
    };
    std::vector<RefinementStep> steps{{1, samplesPerAxis}};
    for (const RefinementStep& step :
         {RefinementStep{1, 2}, RefinementStep{1, 1}, RefinementStep{2, 1}, RefinementStep{4, 1}})
        if (seconds(steps.front()) > quickEnough && seconds(step) <= worthwhile * seconds(steps.front()))
            steps.insert(steps.begin(), step);
    return steps;
}

} // namespace tetra
