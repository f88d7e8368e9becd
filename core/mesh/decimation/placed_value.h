// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace tetra {

/// A point as evaluations read it, in one line of the cache: points of a star lie all over the memory.
struct alignas(32) PlacedValue {
    std::array<double, 3> place{};
    double value = 0;
};

} // namespace tetra
