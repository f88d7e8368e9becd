// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// Colour times opacity, and opacity.
using PremultipliedColour = std::array<float, 4>;

/// Where a ray meets a surface or a line.
struct SurfaceFragment {
    float nearness; ///< q of ViewTransform
    PremultipliedColour colour;
};

/// What surfaces the rays of a tile meet.
struct SurfaceFragments {
    /// Of each sample front to back, no further than to what lets no light through, and then one that is farther than
    /// everything and shows nothing.
    std::vector<SurfaceFragment> fragments;
    std::vector<std::uint32_t> first; ///< for each sample, row by row, the place of its first fragment
    bool empty = true;                ///< no sample meets any
};

} // namespace tetra
