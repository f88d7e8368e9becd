// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/progressive/frame_plan.h"

namespace tetra {

/// Holds a frame rate while the camera moves (R23): learns from the pictures that were drawn, and says how to draw the
/// next one. Knows no clock, no scene and no thread; a value.
class FramePacer {
public:
    /// Pictures a second, above zero.
    void setFrameRate(double perSecond) noexcept { frameRate_ = perSecond; }
    double frameRate() const noexcept { return frameRate_; }

    /// What can be drawn from now on, the finest first; costs and `measured` are its own affair. What was learnt goes
    /// over to the levels nearest in size.
    void setLevels(std::vector<FrameLevel> levels);
    const std::vector<FrameLevel>& levels() const noexcept { return levels_; }

    /// For the next picture of a movement, of a viewport of so many pixels.
    FramePlan nextFrame(double pixels);
    /// For when it rests.
    std::vector<RefinementStep> refinement(double pixels, int samplesPerAxis) const;
    /// What the last of those pictures is expected to take.
    double secondsOfStill(double pixels, int samplesPerAxis) const;
    /// A picture of this level with so many samples took `seconds`.
    void learn(std::size_t level, double samples, const RenderStatistics& statistics, double seconds);

private:
    std::vector<FrameLevel> levels_{FrameLevel{}};
    std::optional<FramePlan> last_;
    double frameRate_ = 15;
};

} // namespace tetra
