// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/volume/block_shading.h"

namespace tetra {

/// Draws the next surface of a ray.
TETRA_SIMD_INLINE void drawSurface(const SurfaceFragment* fragments, bool perspective, std::size_t lane,
                                   SampleBlock& block, BlockLimits& limits)
{
    const SurfaceFragment& surface = fragments[limits.place[lane]];
    const float before = block.light[lane];
    block.red[lane] += before * surface.colour[0];
    block.green[lane] += before * surface.colour[1];
    block.blue[lane] += before * surface.colour[2];
    block.light[lane] = before * (1 - surface.colour[3]);
    if (before > 0.5f && block.light[lane] <= 0.5f)
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
        const Lanes before = lanesOf<Lanes>(block.light, first);
        const auto meets = inside & (next > back) & (before > darkness);
        const Lanes end = meets ? (shading.splitCells ? smaller(next, front) : front) : back;
        CellRays<Lanes> rays = {front, end, slope, ray, {}, {}};
        const Gathered<Lanes> unlit = {lanesOf<Lanes>(block.red, first), lanesOf<Lanes>(block.green, first),
                                       lanesOf<Lanes>(block.blue, first), before};
        Gathered<Lanes> gathered = unlit;
        shade<perspective>(rays, *covered.cell, shading.segments, gathered);
        if (covered.cell->perGradient > 0)
            relight<perspective>(gathered, unlit, rays, *covered.cell);
        keepDepth(block, first, gathered.light, rays.enter, rays.leave);
        putLanes(gathered.red, first, block.red);
        putLanes(gathered.green, first, block.green);
        putLanes(gathered.blue, first, block.blue);
        putLanes(gathered.light, first, block.light);
        front = end;
        more = any(meets);
        for (int lane = 0; more && lane < count; ++lane)
            if (meets[lane])
                drawSurface(shading.fragments, perspective, static_cast<std::size_t>(first + lane), block, limits);
    }
}

} // namespace tetra
