// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tetra {

/// How the segment from `from` to `to` crosses the triangle: 1 leaving by its front (from where its corners run
/// counterclockwise), -1 entering by it, 0 not at all; nothing if it passes through an edge or `to` is in its plane, so
/// that another segment has to tell. `from` is not in the triangle.
enum class Crossing { None, Leaving, Entering, Unclear };
Crossing crossingOf(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& a,
                    const Eigen::Vector3d& b, const Eigen::Vector3d& c);

} // namespace tetra
