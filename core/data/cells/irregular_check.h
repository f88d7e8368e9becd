// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/dataset.h"
#include "core/mesh/boundary.h"

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

/// What the rest of the program relies on for irregular data, checked exactly (S6, S20):
/// - as many finite positions as finite values, and tetrahedra of which each point is a corner;
/// - every tetrahedron is positive;
/// - a face is in one tetrahedron (of the boundary) or in two, which lie on opposite sides of it;
/// - the boundary is a manifold: two of its faces at each of its edges, one fan of them around each of its vertices;
/// - it does not meet itself, not even in a point, and no component of the mesh lies inside another one.
/// So the tetrahedra are a conforming mesh that covers its domain once. There may be several components, holes and
/// cavities, and inner vertices that touch nothing else.
/// Errors: BadInput with a count and an example; Cancelled. O(n log n), one thread, up to 260 bytes a tetrahedron.
Status checkIrregular(const Dataset& dataset, const Progress& progress = {});

/// The same of tetrahedra that are known to be positive, and of their faces; may leave points unused.
Status checkTetrahedra(std::span<const Eigen::Vector3d> positions,
                       std::span<const std::array<std::uint32_t, 4>> tetrahedra, const MeshFaces& faces,
                       const Progress& progress);

} // namespace tetra
