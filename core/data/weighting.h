// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/dataset.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The part of the accuracy that is left far from what a term of a weighting is about, unless it says otherwise.
constexpr double defaultWeightFloor = 0.1;
constexpr double smallestWeightFloor = 1e-6;

/// A place that matters: weight 1 in the box, which may be a single point, falling linearly to `floor` at the distance
/// `reach` from it and beyond. Units of the positions.
struct SpaceWeight {
    Eigen::AlignedBox3d box;
    double reach = 0; ///< 0: `floor` everywhere outside
    double floor = defaultWeightFloor;
};

/// A value that matters: weight 1 for points that have it, falling linearly to `floor` at the difference `reach` and
/// beyond. Units of the values.
struct ValueWeight {
    double value = 0;
    double reach = 0;
    double floor = defaultWeightFloor;
};

/// How much the error at each point counts (R6, 2.3): a mesh's weighted error is the largest weight * |value -
/// interpolation| over the points. The weight of a point is the *largest* of its terms' weights, so that each term
/// says where accuracy is wanted and no term takes away what another asked for. Without terms every weight is 1.
struct Weighting {
    std::vector<SpaceWeight> places;
    std::vector<ValueWeight> values;

    bool empty() const noexcept { return places.empty() && values.empty(); }
    /// In (0, 1].
    double weight(const Eigen::Vector3d& position, double value) const;
};

/// What parseWeighting() reads, for the user.
inline constexpr std::string_view weightingSyntax =
    "point:x,y,z,reach[,floor], box:x0,y0,z0,x1,y1,z1,reach[,floor] or value:q,reach[,floor]";

/// Reads terms of weightingSyntax separated by ';', blanks around them allowed, none at all too. The reach of points
/// and values is above 0, that of boxes at least 0, floors are from 1e-6 to 1. The error (WrongUsage) names the term
/// and what is wrong with it.
Result<Weighting> parseWeighting(std::string_view text);

/// The text that parseWeighting() reads as this weighting: places first, all floors given.
std::string weightingText(const Weighting& weighting);

/// The weight of each of the dataset's points, the same bits on every machine; empty if the weighting is. Uses all
/// threads. Errors: not enough memory, cancelled.
Result<std::vector<float>> pointWeights(const Weighting& weighting, const Dataset& dataset,
                                        const Progress& progress = {});

} // namespace tetra
