// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/queries/tetrahedron_meets.h"

namespace tetra {

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

} // namespace tetra
