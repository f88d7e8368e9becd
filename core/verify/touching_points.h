// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/topology.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The points of a boundary that lie in a closed cell, or on it, which they are no corner of; sorted. There parts of
/// the mesh touch or overlap without having the point in common, as at the contact of two bodies that were meshed apart
/// or at a seam that was not quite closed: the mesh itself has several values at such a place. Exact; cells that are
/// not positive hold nothing. O(n log n), on all threads.
std::vector<std::uint32_t> touchingPoints(std::span<const Eigen::Vector3d> positions,
                                          std::span<const Tetrahedron> tetrahedra, std::span<const Triangle> boundary);

} // namespace tetra
