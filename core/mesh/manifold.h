// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Takes tetrahedra of a conforming mesh with a manifold boundary out of `chosen` (1 for those that are left) until the
/// boundary of the others is a manifold: wherever they hang together by a point or an edge alone, all but the largest
/// part around it; all around a point at which two hollows meet. Returns how many. O(tetrahedra) but for such places.
std::uint64_t restrictToManifold(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::uint32_t points,
                                 std::vector<std::uint8_t>& chosen);

} // namespace tetra
