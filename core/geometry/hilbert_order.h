// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/radix_sort.h"

#include <Eigen/Core>

#include <span>

namespace tetra {

/// How many bits of a key of spatialKeys() count.
inline constexpr int spatialKeyBits = 30;

/// For each point its index and where on a Hilbert curve through the points' box it lies: the curve goes through 1024
/// cubes along the box's longest side, one after its neighbour. Points that are not finite lie anywhere on it.
/// O(points), on all threads of the current arena. May throw std::bad_alloc.
Buffer<KeyedIndex> spatialKeys(std::span<const Eigen::Vector3d> points);

} // namespace tetra
