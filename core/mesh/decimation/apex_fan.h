// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/decimation/star_points.h"

#include <array>
#include <vector>

namespace tetra {

/// Tetrahedra around a common apex, which together fill the star that they replace, as linear functions of the place
/// from the apex.
struct ApexFan {
    /// Rows whose products with a place are the weights of the three vertices besides the apex.
    using Weights = std::array<std::array<double, 3>, 3>;

    std::array<double, 3> apex{};   ///< from the same origin as the points
    double apexValue = 0;           ///< the field at the apex
    std::array<double, 3> lifted{}; ///< the apex in physical space
    std::vector<Weights> weights;
    std::vector<std::array<double, 3>> gradients; ///< of the field
    std::vector<Weights> liftedGradients;         ///< of each physical coordinate; empty: no warping

    /// Adds the tetrahedron of the apex and three corners, all from the apex; `steps` are the corners' values less the
    /// apex's.
    void add(const std::array<std::array<double, 3>, 3>& corners, const std::array<double, 3>& steps);
    /// For the one added last: the corners in physical space less the apex.
    void addLifted(const std::array<std::array<double, 3>, 3>& liftedCorners);
    void clear();
};

/// What below cannot be told from none, because rounding makes as much; and how warpings compare with errors.
struct FanMeasure {
    double leastError = 0;
    double leastWarping = 0;
    double warpingWeight = 0;
};

/// Gives each point to the tetrahedron of the fan that has it, and computes its error and warping (R4, R5) into
/// `points`. Returns the largest of the errors and weighted warpings, or, as soon as that exceeds `bound`, what it is
/// so far.
double evaluateFan(const ApexFan& fan, const FanMeasure& measure, double bound, StarPoints& points);

} // namespace tetra
