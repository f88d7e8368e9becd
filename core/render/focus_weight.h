// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/mesh.h>
#include <tan/render.h>

#include <Eigen/Core>

#include <cstddef>
#include <span>

namespace tetra {

/// The largest of the regions' weights at a place.
double focusWeight(std::span<const FocusRegion> regions, const Eigen::Vector3d& place);

/// The opacity of an opaque surface that has but a share of its places.
inline constexpr double mostSharedOpacity = 1 - 1.0 / 4096;

/// Of a surface at a place: less than Surface::opacity where another one has a share of it.
float opacityAt(float opacity, const FocusShare* share, const Eigen::Vector3d& place);

/// A region as balls and boxes have it in common.
struct RegionShape {
    bool isBall;
    Eigen::Vector3d centre;
    Eigen::Vector3d size; ///< half of a box; of a ball the radius, in each coordinate
    double border;
};
RegionShape shapeOf(const FocusRegion& region);

/// So many regions are taken by shaders.
inline constexpr std::size_t largestRegionCount = 16;

} // namespace tetra
