// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// For each point, the first of those on exactly its place (so its own number if it is the first, or alone); only
/// points with `used` count, the others get their own. O(points), by a hash table; fewer than 2^32 - 1 points.
std::vector<std::uint32_t> firstOnPlace(std::span<const Eigen::Vector3d> positions, const std::vector<bool>& used);

} // namespace tetra
