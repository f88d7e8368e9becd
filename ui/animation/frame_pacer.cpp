// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/animation/frame_pacer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

namespace {

/// Of the time of a frame: pictures do not take the same time each, and they must be shown, too.
constexpr double plannedPart = 0.7;

/// After so many pictures of a level its cost is known; what changes then is the view or the machine, for all levels.
constexpr int firstPictures = 4;

FrameCost changedAlike(FrameCost cost, const FrameCost& before, const FrameCost& after)
{
    cost.order *= after.order / before.order;
    cost.setUp *= after.setUp / before.setUp;
    cost.fill *= after.fill / before.fill;
    cost.rest *= after.rest / before.rest;
    cost.fragmentsPerCrossing *= after.fragmentsPerCrossing / before.fragmentsPerCrossing;
    return cost;
}

/// The level that says most about a mesh of so many tetrahedra: measured ones before others, then the nearest in size.
const FrameLevel& nearestLevel(const std::vector<FrameLevel>& levels, double tetrahedra)
{
    const auto distance = [&](const FrameLevel& level) {
        return std::pair(level.measured == 0, std::abs(std::log((level.tetrahedra + 1) / (tetrahedra + 1))));
    };
    return *std::ranges::min_element(levels, {}, distance);
}

} // namespace

void FramePacer::setLevels(std::vector<FrameLevel> levels)
{
    if (levels.empty())
        levels.emplace_back();
    for (FrameLevel& level : levels) {
        const FrameLevel& known = nearestLevel(levels_, level.tetrahedra);
        level.cost = known.cost;
        const bool same = known.tetrahedra == level.tetrahedra && known.isVolume == level.isVolume;
        level.measured = same ? known.measured : 0;
    }
    if (levels.size() != levels_.size())
        last_.reset();
    levels_ = std::move(levels);
}

FramePlan FramePacer::nextFrame(double pixels)
{
    const bool isFull = kind_ == MovingQuality::Kind::Full;
    if (isFull || (kind_ != MovingQuality::Kind::FrameRate && levels_.size() > 1))
        return {isFull ? 0 : levels_.size() - 1, 1};
    last_ = chooseFrame(levels_, pixels, plannedPart / frameRate_, last_);
    return *last_;
}

std::vector<RefinementStep> FramePacer::refinement(double pixels, int samplesPerAxis) const
{
    return refinementSteps(levels_.front(), pixels, samplesPerAxis);
}

double FramePacer::secondsOfStill(double pixels, int samplesPerAxis) const
{
    return predictedSeconds(levels_.front(), pixels, 1.0 / samplesPerAxis);
}

void FramePacer::learn(std::size_t level, double samples, const RenderStatistics& statistics, double seconds)
{
    if (level >= levels_.size())
        return;
    FrameLevel& drawn = levels_[level];
    const FrameWork work{drawn.isVolume ? drawn.tetrahedra : 0, drawn.triangles, samples};
    const FrameCost before = drawn.cost;
    drawn.cost = learned(drawn.cost, work, statistics, seconds);
    ++drawn.measured;
    for (FrameLevel& other : levels_)
        if (other.measured == 0)
            other.cost = nearestLevel(levels_, other.tetrahedra).cost;
        else if (&other != &drawn && drawn.measured > firstPictures)
            other.cost = changedAlike(other.cost, before, drawn.cost);
}

} // namespace tetra
