// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// Whether two triangles, which have an area and share at most two vertices by number, meet anywhere but in the
/// vertices or the edge that they share. Touching counts, and so do different vertices on one place. Exact.
bool trianglesMeet(std::span<const Eigen::Vector3d> positions, const std::array<std::uint32_t, 3>& a,
                   const std::array<std::uint32_t, 3>& b);

/// How the segment from `from` to `to` crosses the triangle: 1 leaving by its front (from where its corners run
/// counterclockwise), -1 entering by it, 0 not at all; nothing if it passes through an edge or `to` is in its plane, so
/// that another segment has to tell. `from` is not in the triangle.
enum class Crossing { None, Leaving, Entering, Unclear };
Crossing crossingOf(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& a,
                    const Eigen::Vector3d& b, const Eigen::Vector3d& c);

} // namespace tetra
