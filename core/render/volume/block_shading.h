// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/shading.h"
#include "core/render/volume/slab_shading.h"
#include "core/render/volume/volume_tile.h"

#include <tan/render.h>

#include <algorithm>
#include <cmath>

namespace tetra {

/// What the rays of several lanes gather in a cell. For use inside functions compiled for several instruction sets.

/// Rays that may pass a cell.
template <class Lanes> struct CellRays {
    Lanes front, back, slope; ///< of CellSetup
    Lanes ray;                ///< of SampleBlock
    Lanes enter, leave;       ///< w where they come in and go out
};

template <bool perspective, class Lanes> TETRA_SIMD_INLINE void
shade(CellRays<Lanes>& rays, const CellSetup& cell, const ScaledSegment* segments, Gathered<Lanes>& gathered)
{
    const Lanes ones = Lanes{} + 1.0f;
    const Lanes front = rays.front > rays.back ? rays.front : ones;
    const Lanes back = rays.front > rays.back ? rays.back : ones;
    Lanes valueIn, valueOut;
    if constexpr (perspective) {
        const Lanes both = 1.0f / (front * back);
        rays.enter = back * both;
        rays.leave = front * both;
        valueIn = rays.slope * rays.enter + cell.constant;
        valueOut = rays.slope * rays.leave + cell.constant;
    } else {
        rays.enter = -front;
        rays.leave = -back;
        valueIn = rays.slope + cell.constant * front;
        valueOut = rays.slope + cell.constant * back;
    }
    const Lanes length = (rays.leave - rays.enter) * rays.ray;
    if (cell.simple)
        addSlab(gathered, segments[cell.firstSegment], cell.thickness, valueIn, valueOut, length);
    else
        addSlices(gathered, segments, cell, valueIn, valueOut, length);
}

/// Lights what a cell added, as a surface across the gradient would be lit (shading.h). The cosine between the gradient
/// and a ray is the value's change for one unit of w, over that for one unit of length along the gradient and the ray's
/// length for one unit of w.
template <bool perspective, class Lanes> TETRA_SIMD_INLINE void
relight(Gathered<Lanes>& gathered, const Gathered<Lanes>& before, const CellRays<Lanes>& rays, const CellSetup& cell)
{
    const Lanes ones = Lanes{} + 1.0f;
    Lanes change = Lanes{} + cell.constant;
    if constexpr (perspective)
        change = rays.slope;
    const Lanes cosine = smaller(larger(change, -change) * cell.perGradient / rays.ray, ones);
    const Lanes factor = Shading::ambient + Shading::diffuse * cosine;
    Lanes power = cosine * cosine;
    for (int doubled = 0; doubled < 4; ++doubled)
        power *= power;
    const Lanes opacity = before.transmittance - gathered.transmittance;
    const Lanes specular = Shading::specular * power * opacity;
    gathered.red = before.red + smaller((gathered.red - before.red) * factor + specular, opacity);
    gathered.green = before.green + smaller((gathered.green - before.green) * factor + specular, opacity);
    gathered.blue = before.blue + smaller((gathered.blue - before.blue) * factor + specular, opacity);
}

/// Shades blocks that a cell covers. For use inside functions compiled for several instruction sets.

/// A block that a cell covers, to be shaded.
struct CoveredBlock {
    Float8 front, back, slope;
    SampleBlock* block;
    const CellSetup* cell;
    BlockLimits* meets; ///< the block's, if one of its rays meets a surface in the cell or before it
};

/// What is drawn beside the cells' own slabs.
enum class KernelFeatures {
    None,
    Depth,
    All, ///< depth, surfaces, clip planes, light
};

/// Where the light of some rays, from lane `first` of a block, fell to a half inside a cell.
template <class Lanes>
TETRA_SIMD_INLINE void keepDepth(SampleBlock& block, int first, Lanes transmittance, Lanes enter, Lanes leave)
{
    const Lanes before = lanesOf<Lanes>(block.transmittance, first);
    if (!any((before > 0.5f) & (transmittance <= 0.5f)))
        return;
    for (int lane = 0; lane < static_cast<int>(sizeof(Lanes) / sizeof(float)); ++lane)
        if (before[lane] > 0.5f && transmittance[lane] <= 0.5f) {
            const float left = std::max(transmittance[lane], 1e-12f);
            const float share = std::log(2 * before[lane]) / std::log(before[lane] / left);
            block.depth[first + lane] = enter[lane] + share * (leave[lane] - enter[lane]);
        }
}

TETRA_SIMD_INLINE void store(SampleBlock& block, Float8 red, Float8 green, Float8 blue, Float8 transmittance)
{
    block.red = red;
    block.green = green;
    block.blue = blue;
    block.transmittance = transmittance;
}

template <bool perspective, KernelFeatures extras>
TETRA_SIMD_INLINE void shadeOne(const CoveredBlock& covered, const ScaledSegment* segments, bool depth)
{
    SampleBlock& block = *covered.block;
    CellRays<Float8> rays = {covered.front, covered.back, covered.slope, block.ray, {}, {}};
    Gathered<Float8> gathered = {block.red, block.green, block.blue, block.transmittance};
    shade<perspective>(rays, *covered.cell, segments, gathered);
    if constexpr (extras == KernelFeatures::All)
        if (covered.cell->perGradient > 0)
            relight<perspective>(gathered, {block.red, block.green, block.blue, block.transmittance}, rays,
                                 *covered.cell);
    if (extras == KernelFeatures::Depth || (extras == KernelFeatures::All && depth))
        keepDepth(block, 0, gathered.transmittance, rays.enter, rays.leave);
    store(block, gathered.red, gathered.green, gathered.blue, gathered.transmittance);
}

template <bool perspective, KernelFeatures extras>
TETRA_SIMD_INLINE void shadeHalves(const CoveredBlock& covered, const ScaledSegment* segments, bool depth)
{
    SampleBlock& block = *covered.block;
    const Halves front = halvesOf(covered.front), back = halvesOf(covered.back), slope = halvesOf(covered.slope);
    const Halves ray = halvesOf(block.ray), left = halvesOf(block.transmittance);
    const Halves red = halvesOf(block.red), green = halvesOf(block.green), blue = halvesOf(block.blue);
    CellRays<Float4> rays[2] = {{front.low, back.low, slope.low, ray.low, {}, {}},
                                {front.high, back.high, slope.high, ray.high, {}, {}}};
    const Gathered<Float4> before[2] = {{red.low, green.low, blue.low, left.low},
                                        {red.high, green.high, blue.high, left.high}};
    Gathered<Float4> gathered[2] = {before[0], before[1]};
    for (int half = 0; half < 2; ++half) {
        shade<perspective>(rays[half], *covered.cell, segments, gathered[half]);
        if constexpr (extras == KernelFeatures::All)
            if (covered.cell->perGradient > 0)
                relight<perspective>(gathered[half], before[half], rays[half], *covered.cell);
    }
    if (extras == KernelFeatures::Depth || (extras == KernelFeatures::All && depth))
        keepDepth(block, 0, whole(gathered[0].transmittance, gathered[1].transmittance),
                  whole(rays[0].enter, rays[1].enter), whole(rays[0].leave, rays[1].leave));
    store(block, whole(gathered[0].red, gathered[1].red), whole(gathered[0].green, gathered[1].green),
          whole(gathered[0].blue, gathered[1].blue), whole(gathered[0].transmittance, gathered[1].transmittance));
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

/// Two blocks of one cell. `depth`: whether it is wanted, of KernelFeatures::All.
template <bool perspective, KernelFeatures extras> TETRA_SIMD_INLINE void
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
                                  joined(a.transmittance, b.transmittance)};
    shade<perspective>(rays, *one.cell, segments, gathered);
    if constexpr (extras == KernelFeatures::All)
        if (one.cell->perGradient > 0)
            relight<perspective>(gathered,
                                 {joined(a.red, b.red), joined(a.green, b.green), joined(a.blue, b.blue),
                                  joined(a.transmittance, b.transmittance)},
                                 rays, *one.cell);
    if (extras == KernelFeatures::Depth || (extras == KernelFeatures::All && depth)) {
        keepDepth(a, 0, lowHalf(gathered.transmittance), lowHalf(rays.enter), lowHalf(rays.leave));
        keepDepth(b, 0, highHalf(gathered.transmittance), highHalf(rays.enter), highHalf(rays.leave));
    }
    store(a, lowHalf(gathered.red), lowHalf(gathered.green), lowHalf(gathered.blue), lowHalf(gathered.transmittance));
    store(b, highHalf(gathered.red), highHalf(gathered.green), highHalf(gathered.blue),
          highHalf(gathered.transmittance));
}

/// Draws the next surface of a ray.
TETRA_SIMD_INLINE void drawSurface(const SurfaceFragment* fragments, bool perspective, std::size_t lane,
                                   SampleBlock& block, BlockLimits& limits)
{
    const SurfaceFragment& surface = fragments[limits.place[lane]];
    const float before = block.transmittance[lane];
    block.red[lane] += before * surface.colour[0];
    block.green[lane] += before * surface.colour[1];
    block.blue[lane] += before * surface.colour[2];
    block.transmittance[lane] = before * (1 - surface.colour[3]);
    if (before > 0.5f && block.transmittance[lane] <= 0.5f)
        block.depth[lane] = perspective ? 1 / surface.nearness : -surface.nearness;
    limits.next[lane] = fragments[++limits.place[lane]].nearness;
}

/// The rays of a block, or half of it, that starts with lane `first`, through a cell and the surfaces in it and before
/// it: each surface ends one slab and begins the next (R21).
template <bool perspective, class Lanes>
TETRA_SIMD_INLINE void shadeAmongSurfaces(const CoveredBlock& covered, int first, const TileShading& shading)
{
    constexpr int count = static_cast<int>(sizeof(Lanes) / sizeof(float));
    SampleBlock& block = *covered.block;
    BlockLimits& limits = *covered.meets;
    Lanes front = lanesOf<Lanes>(covered.front, first);
    const Lanes back = lanesOf<Lanes>(covered.back, first);
    const Lanes slope = lanesOf<Lanes>(covered.slope, first);
    const Lanes ray = lanesOf<Lanes>(block.ray, first);
    const auto inside = front > back;
    bool more = true;
    while (more) {
        const Lanes next = lanesOf<Lanes>(limits.next, first);
        const Lanes before = lanesOf<Lanes>(block.transmittance, first);
        const auto meets = inside & (next > back) & (before > opaqueThreshold);
        const Lanes end = meets ? (shading.splitCells ? smaller(next, front) : front) : back;
        CellRays<Lanes> rays = {front, end, slope, ray, {}, {}};
        const Gathered<Lanes> unlit = {lanesOf<Lanes>(block.red, first), lanesOf<Lanes>(block.green, first),
                                       lanesOf<Lanes>(block.blue, first), before};
        Gathered<Lanes> gathered = unlit;
        shade<perspective>(rays, *covered.cell, shading.segments, gathered);
        if (covered.cell->perGradient > 0)
            relight<perspective>(gathered, unlit, rays, *covered.cell);
        keepDepth(block, first, gathered.transmittance, rays.enter, rays.leave);
        putLanes(gathered.red, first, block.red);
        putLanes(gathered.green, first, block.green);
        putLanes(gathered.blue, first, block.blue);
        putLanes(gathered.transmittance, first, block.transmittance);
        front = end;
        more = any(meets);
        for (int lane = 0; more && lane < count; ++lane)
            if (meets[lane])
                drawSurface(shading.fragments, perspective, std::size_t(first) + std::size_t(lane), block, limits);
    }
}

} // namespace tetra
