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

} // namespace tetra
