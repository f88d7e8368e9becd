// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// Where a closed surface, the boundary of positive tetrahedra that match, shows that they overlap.
struct BoundaryFaults {
    std::uint64_t meetings = 0;             ///< pairs of triangles that meet where they share nothing; ...
    std::array<std::uint32_t, 2> meeting{}; ///< ... one of them
    std::uint64_t buried = 0;               ///< components whose outer side is inside of other tetrahedra; ...
    std::uint32_t buriedTriangle = 0;       ///< ... a triangle of one
    bool none() const { return meetings == 0 && buried == 0; }
};

/// Together with matching faces and a manifold boundary, finding none of this proves that the tetrahedra cover what
/// they cover once: how many of them lie over a point is the boundary's winding number there, which only changes at the
/// boundary, by one, and is zero just outside each of its components. Exact, but for which side of a closed surface is
/// the inner one, which its volume in doubles tells. Ends counting early when cancelled; expected O(n log n) for a
/// surface that does not meet itself much. `triangles` are a manifold, seen from outside counterclockwise.
BoundaryFaults checkBoundary(std::span<const Eigen::Vector3d> positions,
                             std::span<const std::array<std::uint32_t, 3>> triangles, const Progress& progress);

} // namespace tetra
