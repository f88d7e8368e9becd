// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/boundary.h"

#include <tan/base.h>
#include <tan/data.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tetra {

/// What the rest of the program relies on for irregular data, checked exactly (S6, S20):
/// - as many finite positions as finite values, and tetrahedra of which each point is a corner;
/// - every tetrahedron is positive;
/// - a face is in one tetrahedron (of the boundary) or in two, which lie on opposite sides of it;
/// - no two tetrahedra have a volume in common.
/// So the tetrahedra cover their domain once. There may be several components, holes and cavities, and the boundary may
/// touch itself (C10): in points and edges that more than two of its faces have, and where a corner, an edge or a face
/// lies on another face without being the same.
/// Errors: BadInput with a count and an example; Cancelled. O(n log n), one thread, up to 260 bytes a tetrahedron.
Status checkIrregular(const Dataset& dataset, const Progress& progress = {});

/// Pairs of tetrahedra that have a volume in common.
struct MeshOverlaps {
    std::vector<std::array<std::uint32_t, 2>> pairs; ///< sorted
    bool complete = true;                            ///< false: `enough` said so before all were found
};

/// Looks for overlaps of tetrahedra that are known to be positive, and of their faces. Finds those that show at the
/// boundary or at a face that is not shared as it should be; none only if there are none at all. `enough` is told of
/// each pair and says whether to stop. Where nothing is wrong with the faces it looks at the boundary alone, O(n) and
/// O(b log b) of its faces; else at all tetrahedra, O(n log n). Exact. Ends early when cancelled.
MeshOverlaps findOverlaps(std::span<const Eigen::Vector3d> positions,
                          std::span<const std::array<std::uint32_t, 4>> tetrahedra, const MeshFaces& faces,
                          const std::function<bool(std::uint32_t, std::uint32_t)>& enough, const Progress& progress);

} // namespace tetra
