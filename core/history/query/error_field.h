// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/query.h>

#include <algorithm>
#include <array>

namespace tetra {

using Corners = std::array<Eigen::Vector3d, 4>;

/// Whether a tetrahedron, of any orientation, and a closed box have a common point: separating axes. Two bodies that
/// are apart by less than `tolerance`, relative to the coordinates, meet; with a tolerance of 0 the answer is exact as
/// far as doubles are, so for coordinates that are small integers. What is not a number meets everything.
bool tetrahedronMeetsBox(const Corners& corners, const Box& box, double tolerance);

/// The square of the distance of a place from a tetrahedron, 0 within, to rounding. NaN for what is not a number.
double squaredDistance(const Corners& corners, const Eigen::Vector3d& place);

/// The convex hull of four corners moved by at most `margin`, with a box around it that holds every point of it as
/// doubles round it.
struct Hull {
    Hull(const Corners& corners, double margin);

    const Corners& corners; ///< not owned
    double margin;          ///< not negative
    Eigen::Vector3d least;
    Eigen::Vector3d largest;
    /// Nothing else holds if a number among the corners or the margin is none, or infinite.
    bool finite;
};

/// Bounds on distanceTo(region, place) for all places of a finite hull, from its box: never more, or never less, than
/// what that function returns.
double nearestDistance(const Region& region, const Hull& hull);
double farthestDistance(const Region& region, const Hull& hull);

/// Whether hull and region have a common point, exactly but for rounding and for the margin, in favour of yes: if not,
/// distanceTo() is positive at every place of the hull.
bool meets(const Region& region, const Hull& hull);

/// Of numbers that are not negative, infinity among them. Never decreasing in either of them, also in doubles: so least
/// numbers make a least number.
inline double applied(FieldOperation operation, double first, double second)
{
    switch (operation) {
    case FieldOperation::Sum: return first + second;
    case FieldOperation::Product: return first > 0 && second > 0 ? first * second : 0; // infinity times 0 is 0
    case FieldOperation::Smaller: return std::min(first, second);
    case FieldOperation::Larger: return std::max(first, second);
    }
    return 0;
}

} // namespace tetra
