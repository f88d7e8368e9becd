// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

using SurfaceTriangle = std::array<std::uint32_t, 3>; ///< by numbers of points, in either orientation

/// Whether two triangles of a surface have more in common than the corner or edge that they share by number: touching
/// counts, so does lying on each other, as do two with the same corners (S12). Both have an area. Exact, for the
/// coordinates that orientationSign() takes.
bool surfaceTrianglesMeet(std::span<const Eigen::Vector3d> positions, const SurfaceTriangle& one,
                          const SurfaceTriangle& other);

/// Whether its corners lie on a line. Exact.
bool withoutArea(std::span<const Eigen::Vector3d> positions, const SurfaceTriangle& triangle);

/// How the segment from `from` to `to` crosses the triangle: 1 leaving by its front (from where its corners run
/// counterclockwise), -1 entering by it, 0 not at all; nothing if it passes through an edge or `to` is in its plane, so
/// that another segment has to tell. `from` is not in the triangle.
enum class Crossing { None, Leaving, Entering, Unclear };
Crossing crossingOf(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& a,
                    const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// The weights of a triangle's corners whose mean is nearest to the origin (C. Ericson, "Real-Time Collision
/// Detection", 2005, 5.1.5).
std::array<double, 3> nearestWeights(const std::array<std::array<double, 3>, 3>& corners);

} // namespace tetra
