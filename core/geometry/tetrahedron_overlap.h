// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// Whether two positive tetrahedra, by numbers of points, have a volume in common; touching is none. Exact, for the
/// coordinates that orientationSign() takes. Some microseconds for two that are close.
bool tetrahedraOverlap(std::span<const Eigen::Vector3d> positions, const std::array<std::uint32_t, 4>& one,
                       const std::array<std::uint32_t, 4>& other);

} // namespace tetra
