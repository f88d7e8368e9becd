// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/model.h>
#include <tan/query.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
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

/// How the warping of curvilinear and irregular data is limited beside the error (C1).
enum class WarpingLimit { AsError, Own, None };
struct WarpingChoice {
    WarpingLimit limit = WarpingLimit::AsError;
    double percent = 1; ///< of the diagonal, if Own
    bool operator==(const WarpingChoice&) const = default;

    /// What one number on the scale asks for: this error in % of the value range, and the warping by it or as chosen.
    Accuracy with(double error) const;
};

/// What one number on the scale asks for if nothing else is chosen.
Accuracy bothWithin(double percent);

/// Where an error (in %) lies on the scale, in [0, 1].
double accuracyPosition(double percent);
/// The error at a position, to three significant digits; zero in the outer half of the gap.
double accuracyAt(double position);
/// The next round number that is finer (steps > 0) or coarser (steps < 0).
double steppedAccuracy(double percent, int steps);

/// What a key (Qt::Key) does on the scale: arrows step, page keys step wider, Home and End go to its ends.
std::optional<double> accuracyByKey(double percent, int key);

/// A point of the curve of Fig. 10.
struct CurvePoint {
    double error = 0; ///< %
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0;
};

/// The size of the mesh against the error, from coarse to fine over the whole scale; the last point is at zero. With a
/// warping of its own that of the prefix, which the mesh does not exceed. O(points * log sites), and then O(points *
/// batches).
std::vector<CurvePoint> sizeAgainstError(const Model& model, const WarpingChoice& warping = {}, int points = 240);

/// 1 % if its mesh is quick to extract and to draw. Else the most accurate round number from 2 % upwards whose mesh can
/// still be worked with: what a coarser one shows is more often its error than the data.
double startingError(const Model& model);
/// The same, given the number of tetrahedra at an error in %.
double startingError(const std::function<std::uint64_t(double percent)>& tetrahedraAt);

} // namespace tetra
