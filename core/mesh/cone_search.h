// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/mesh/star.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tetra {

/// Points are searched for this many at a time; their arrays are padded to a multiple of it.
constexpr std::size_t coneSearchLanes = 8;

/// The coordinates of points relative to a star's apex.
struct ConePoints {
    std::span<const float> x, y, z;
};

/// owners[i] = the last face of the star whose cone, seen from the apex, contains point i. Exact: signs of integers, in
/// floats where the star is small enough, else in doubles. Branch free, O(points * faces). `planes` is room to work in.
void findCones(const Star& star, const ConePoints& points, Buffer<std::array<float, 12>>& planes,
               std::span<std::int32_t> owners);

} // namespace tetra
