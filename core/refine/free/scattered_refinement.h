// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/build.h>

#include <Eigen/Core>

#include <cstdint>
#include <span>

namespace tetra {

class SavedState;

/// Points anywhere in space, no two on one place, each with a value. Owns nothing.
struct ScatteredPoints {
    std::span<const Eigen::Vector3d> positions; ///< finite
    std::span<const double> values;             ///< finite, one for each position
    std::span<const float> weights;             ///< that errors are multiplied by (R6), in (0, 1]; empty: all are 1
};

inline constexpr MarkedText noMemoryForPoints = Message::marked(
    "Not enough memory to refine these points. Close other programs, use a machine with more memory, or "
    "take a part of the points.");

struct ScatteredRefinementResult {
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0; ///< all that ever lived
    float finalKey = 0;
};

/// Greedy refinement of scattered points (R1, 3.1, R8): starting from the corners of their convex hull, inserts the
/// point of the largest error until no point's error exceeds `stopError`, in units of the values. Ties go to the first
/// point. The history goes to `sink` while it is made, then sink.finish(). If there is a `state` of these points and
/// this stop, goes on from there, and keeps it up to date. One thread; about 700 bytes a site and 150 a point. Errors:
/// fewer than four points, all of them on a line or in a plane, two on one place, refused memory, the sink's,
/// cancelled.
Result<ScatteredRefinementResult> refineScattered(const ScatteredPoints& points, double stopError, HistorySink& sink,
                                                  const Progress& progress = {}, SavedState* state = nullptr);

} // namespace tetra
