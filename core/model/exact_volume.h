// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tetra {

/// The sign of the volume of a tetrahedron, det(b - a, c - a, d - a): 1, 0 or -1, exact for all finite doubles. In
/// doubles where a bound on their rounding allows it, else in whole numbers of any length. For verification: shares
/// nothing with what builds.
int volumeSign(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d);

} // namespace tetra
