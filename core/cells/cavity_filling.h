// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cells/cell_split.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace tetra {

/// Tetrahedra of positive volume between the corners of a closed surface, without a new point, that end on exactly its
/// triangles (seen from outside counterclockwise); nothing if there are none, or if they were not found in
/// the trials that are left: `stepsLeft`, which this uses up, and 5000. A search that goes back where it gets stuck:
/// for the few corners of one cell. Whatever it finds fills what the surface encloses once, if the surface does not
/// meet itself: all pieces are positive and their inner faces cancel.
std::optional<CellPieces> fillCavity(std::span<const Eigen::Vector3d> positions, const CellSurface& surface,
                                     std::uint64_t& stepsLeft);

} // namespace tetra
