// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/progressive/frame_pacer.h"

#include <algorithm>
#include <cmath>

namespace tetra {
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
