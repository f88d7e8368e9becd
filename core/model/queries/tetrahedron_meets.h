// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/queries/error_field.h"

#include <Eigen/Core>

#include <array>

namespace tetra {

using Corners = std::array<Eigen::Vector3d, 4>;

/// Whether a tetrahedron, of any orientation, and a closed box have a common point: separating axes. Two bodies that
/// are apart by less than `tolerance`, relative to the coordinates, meet; with a tolerance of 0 the answer is exact as
/// far as doubles are, so for coordinates that are small integers. What is not a number meets everything.
bool tetrahedronMeetsBox(const Corners& corners, const Box& box, double tolerance);

/// The square of the distance of a place from a tetrahedron, 0 within, to rounding. NaN for what is not a number.
double squaredDistance(const Corners& corners, const Eigen::Vector3d& place);

} // namespace tetra
