// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/boundary.h"

#include <tan/base.h>
#include <tan/data.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

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
