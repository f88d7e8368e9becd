// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/view.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace tetra {

/// The levels of detail of the paper's tables, % of the value range.
inline constexpr std::array<double, 8> accuracyPresets{4, 3, 2, 1, 0.5, 0.2, 0.1, 0};

/// The slider and the curve share one scale, the same for every model: coarse on the left, fine on the right,
/// logarithmic between these two, then a gap, and zero at the very end.
inline constexpr double coarsestOnScale = 20;
inline constexpr double finestOnScale = 0.01;
/// The position where the logarithmic part ends.
inline constexpr double logarithmicPart = 0.94;

/// What one number on the scale asks for if nothing else is chosen.
TAN_INTERNAL Accuracy bothWithin(double percent);

/// Where an error (in %) lies on the scale, in [0, 1].
TAN_INTERNAL double accuracyPosition(double percent);
/// The error at a position, to three significant digits; zero in the outer half of the gap.
TAN_INTERNAL double accuracyAt(double position);
/// The next round number that is finer (steps > 0) or coarser (steps < 0).
TAN_INTERNAL double steppedAccuracy(double percent, int steps);

/// A round number of tetrahedra, larger (steps > 0) or smaller.
TAN_INTERNAL std::uint64_t steppedBudget(std::uint64_t budget, int steps);

/// A point of the curve of Fig. 10.
struct CurvePoint {
    double error = 0; ///< %
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0;
};

/// The size of the mesh against the error, from coarse to fine over the whole scale; the last point is at zero. With a
/// warping of its own that of the prefix, which the mesh does not exceed. O(points * log sites), and then O(points *
/// batches).
TAN_INTERNAL std::vector<CurvePoint> sizeAgainstError(const Model& model, const WarpingChoice& warping = {},
                                                      int points = 240);

/// startingError() of a model (tan/view.h), given the number of its tetrahedra at an error in %, and whether the shape
/// of its domain is simplified, too.
TAN_INTERNAL double startingError(const std::function<std::uint64_t(double percent)>& tetrahedraAt,
                                  bool hasOwnShape = false);

} // namespace tetra
