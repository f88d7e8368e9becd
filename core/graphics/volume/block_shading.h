// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/volume/block_lanes.h"
#include "core/graphics/volume/cell_light.h"
#include "core/graphics/volume/volume_tile.h"

#include <algorithm>
#include <cmath>

namespace tetra {

/// Shades blocks that a cell covers. For use inside functions compiled for several instruction sets.

/// A block that a cell covers, to be shaded.
struct CoveredBlock {
    Float8 front, back, slope;
    SampleBlock* block;
    const CellSetup* cell;
    BlockLimits* meets; ///< the block's, if one of its rays meets a surface in the cell or before it
};

/// What is drawn beside the cells' own slabs.
enum class Extras {
    None,
    Depth,
    All, ///< depth, surfaces, clip planes, light
};

/// Where the light of some rays, from lane `first` of a block, fell to a half inside a cell.
template <class Lanes>
TETRA_SIMD_INLINE void keepDepth(SampleBlock& block, int first, Lanes light, Lanes enter, Lanes leave)
{
    const Lanes before = lanesOf<Lanes>(block.light, first);
    if (!any((before > 0.5f) & (light <= 0.5f)))
        return;
    for (int lane = 0; lane < static_cast<int>(sizeof(Lanes) / sizeof(float)); ++lane)
        if (before[lane] > 0.5f && light[lane] <= 0.5f) {
            const float left = std::max(light[lane], 1e-12f);
            const float share = std::log(2 * before[lane]) / std::log(before[lane] / left);
            block.depth[first + lane] = enter[lane] + share * (leave[lane] - enter[lane]);
        }
}

TETRA_SIMD_INLINE void store(SampleBlock& block, Float8 red, Float8 green, Float8 blue, Float8 light)
{
    block.red = red;
    block.green = green;
    block.blue = blue;
    block.light = light;
}

template <bool perspective, Extras extras>
TETRA_SIMD_INLINE void shadeOne(const CoveredBlock& covered, const ScaledSegment* segments, bool depth)
{
    SampleBlock& block = *covered.block;
    CellRays<Float8> rays = {covered.front, covered.back, covered.slope, block.ray, {}, {}};
    Gathered<Float8> gathered = {block.red, block.green, block.blue, block.light};
    shade<perspective>(rays, *covered.cell, segments, gathered);
    if constexpr (extras == Extras::All)
        if (covered.cell->perGradient > 0)
            relight<perspective>(gathered, {block.red, block.green, block.blue, block.light}, rays, *covered.cell);
    if (extras == Extras::Depth || (extras == Extras::All && depth))
        keepDepth(block, 0, gathered.light, rays.enter, rays.leave);
    store(block, gathered.red, gathered.green, gathered.blue, gathered.light);
}

template <bool perspective, Extras extras>
TETRA_SIMD_INLINE void shadeHalves(const CoveredBlock& covered, const ScaledSegment* segments, bool depth)
{
    SampleBlock& block = *covered.block;
    const Halves front = halvesOf(covered.front), back = halvesOf(covered.back), slope = halvesOf(covered.slope);
    const Halves ray = halvesOf(block.ray), left = halvesOf(block.light);
    const Halves red = halvesOf(block.red), green = halvesOf(block.green), blue = halvesOf(block.blue);
    CellRays<Float4> rays[2] = {{front.low, back.low, slope.low, ray.low, {}, {}},
                                {front.high, back.high, slope.high, ray.high, {}, {}}};
    const Gathered<Float4> before[2] = {{red.low, green.low, blue.low, left.low},
                                        {red.high, green.high, blue.high, left.high}};
    Gathered<Float4> gathered[2] = {before[0], before[1]};
    for (int half = 0; half < 2; ++half) {
        shade<perspective>(rays[half], *covered.cell, segments, gathered[half]);
        if constexpr (extras == Extras::All)
            if (covered.cell->perGradient > 0)
                relight<perspective>(gathered[half], before[half], rays[half], *covered.cell);
    }
    if (extras == Extras::Depth || (extras == Extras::All && depth))
        keepDepth(block, 0, whole(gathered[0].light, gathered[1].light), whole(rays[0].enter, rays[1].enter),
                  whole(rays[0].leave, rays[1].leave));
    store(block, whole(gathered[0].red, gathered[1].red), whole(gathered[0].green, gathered[1].green),
          whole(gathered[0].blue, gathered[1].blue), whole(gathered[0].light, gathered[1].light));
}

TETRA_SIMD_INLINE Float16 joined(Float8 low, Float8 high)
{
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}
TETRA_SIMD_INLINE Float8 lowHalf(Float16 lanes)
{
    return __builtin_shufflevector(lanes, lanes, 0, 1, 2, 3, 4, 5, 6, 7);
}
TETRA_SIMD_INLINE Float8 highHalf(Float16 lanes)
{
    return __builtin_shufflevector(lanes, lanes, 8, 9, 10, 11, 12, 13, 14, 15);
}

/// Two blocks of one cell. `depth`: whether it is wanted, of Extras::All.
template <bool perspective, Extras extras> TETRA_SIMD_INLINE void
shadeTwo(const CoveredBlock& one, const CoveredBlock& other, const ScaledSegment* segments, bool depth)
{
    SampleBlock &a = *one.block, &b = *other.block;
    CellRays<Float16> rays = {joined(one.front, other.front),
                              joined(one.back, other.back),
                              joined(one.slope, other.slope),
                              joined(a.ray, b.ray),
                              {},
                              {}};
    Gathered<Float16> gathered = {joined(a.red, b.red), joined(a.green, b.green), joined(a.blue, b.blue),
                                  joined(a.light, b.light)};
    shade<perspective>(rays, *one.cell, segments, gathered);
    if constexpr (extras == Extras::All)
        if (one.cell->perGradient > 0)
            relight<perspective>(
                gathered,
                {joined(a.red, b.red), joined(a.green, b.green), joined(a.blue, b.blue), joined(a.light, b.light)},
                rays, *one.cell);
    if (extras == Extras::Depth || (extras == Extras::All && depth)) {
        keepDepth(a, 0, lowHalf(gathered.light), lowHalf(rays.enter), lowHalf(rays.leave));
        keepDepth(b, 0, highHalf(gathered.light), highHalf(rays.enter), highHalf(rays.leave));
    }
    store(a, lowHalf(gathered.red), lowHalf(gathered.green), lowHalf(gathered.blue), lowHalf(gathered.light));
    store(b, highHalf(gathered.red), highHalf(gathered.green), highHalf(gathered.blue), highHalf(gathered.light));
}

} // namespace tetra
