// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/irregular/boundary_surfaces.h"

#include <Eigen/Core>

#include <span>

namespace tetra {

/// Whether two triangles that are not flat have a place in common besides the points that they share by number: they
/// cross, touch, or lie on one another. Exact for all finite doubles. At most two points are shared.
bool facesMeet(std::span<const Eigen::Vector3d> positions, const PointTriangle& first, const PointTriangle& second);

/// Whether the segment and the triangle, which is not flat, have a place in common, their ends included. Exact.
bool segmentMeetsTriangle(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b, const Eigen::Vector3d& c);

} // namespace tetra
