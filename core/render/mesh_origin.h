// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <span>

namespace tetra {

/// What the positions of a mesh are told relative to where they become floats, which far from zero would be too coarse:
/// the first that is finite, zero if none is. O(n).
inline Eigen::Vector3d meshOrigin(std::span<const Eigen::Vector3d> positions)
{
    const auto finite = std::ranges::find_if(positions, [](const auto& position) { return position.allFinite(); });
    return finite == positions.end() ? Eigen::Vector3d(0, 0, 0) : *finite;
}

} // namespace tetra
