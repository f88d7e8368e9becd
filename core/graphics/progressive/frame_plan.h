// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/progressive/frame_cost.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// The numbers of tetrahedra to prepare for moving pictures of a mesh of `whole` tetrahedra, falling: a quarter each
/// time, as long as that is worth it.
std::vector<std::uint64_t> coarserMeshes(std::uint64_t whole);

/// A mesh that a picture can be drawn of, and what that has cost so far.
struct FrameLevel {
    double tetrahedra = 0; ///< of the mesh
    bool isVolume = false; ///< else only the triangles are drawn
    double triangles = 0;
    FrameCost cost{};
    int measured = 0; ///< pictures of this level that the cost is from
};

/// How to draw a picture while there is little time.
struct FramePlan {
    std::size_t level = 0; ///< 0 is the finest
    double reduction = 1;  ///< its width and height are divided by this, one sample a pixel
    bool operator==(const FramePlan&) const = default;
};

/// Of a picture of so many pixels, with one sample each.
double predictedSeconds(const FrameLevel& level, double pixels, double reduction);

/// The plan that loses least against the finest level at full size, of those that should take no more than `budget`
/// seconds, or the quickest if none does. `last` is kept as long as it does not clearly miss the budget and no better
/// one would clearly keep it. Levels are in falling size, at least one.
FramePlan chooseFrame(std::span<const FrameLevel> levels, double pixels, double budget,
                      const std::optional<FramePlan>& last);

/// A picture of the finest level on the way to the best one.
struct RefinementStep {
    double reduction = 1;
    int samplesPerAxis = 1;
    bool operator==(const RefinementStep&) const = default;
};

/// What to draw when the camera rests: the last step is the picture at full size with `samplesPerAxis`, and before it,
/// if that will take long, such as take a fraction of it, so that all take little longer than the last alone.
std::vector<RefinementStep> refinementSteps(const FrameLevel& finest, double pixels, int samplesPerAxis);

} // namespace tetra
