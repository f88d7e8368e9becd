// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace tetra {

/// Integer weights of the squared coordinate differences, in the ratio of the squared spacings: with them the in-sphere
/// test of physical space stays exact in lattice coordinates (S8). (1, 1, 1) for cubic cells.
using LatticeMetric = std::array<std::uint32_t, 3>;

/// The weights for a lattice: exact ratios where small integers hold them, else the closest for which every in-sphere
/// determinant stays below 2^53 and so exact in a double. Error: the lattice is too large even for (1, 1, 1).
Result<LatticeMetric> latticeMetric(const std::array<std::uint32_t, 3>& size, const Eigen::Vector3d& spacing);

/// Whether a lattice of this size is exact with this metric.
bool exactWithMetric(const std::array<std::uint32_t, 3>& size, const LatticeMetric& metric);

} // namespace tetra
