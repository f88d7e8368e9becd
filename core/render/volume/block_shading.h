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

/// Where lit rays are: their samples in the tile, and for one unit of w how far they go right and down, and how long
/// they are.
template <class Lanes> struct LitRays {
    Lanes x, y;
    Lanes right, down, ray;
    float perFullGradient; ///< of TileShading
};

/// The light at a place of each ray: of LightAlong.
template <class Lanes> struct LightThere {
    Lanes factor, highlight, share;
};

/// `x`, `y`: samples of the tile.
template <class Lanes> TETRA_SIMD_INLINE LitRays<Lanes> litRays(const TileShading& shading, Lanes x, Lanes y, Lanes ray)
{
    return {x,
            y,
            (x + shading.firstX) * shading.slopePerSample[0],
            (y + shading.firstY) * shading.slopePerSample[1],
            ray,
            shading.perFullGradient};
}

template <class Lanes> TETRA_SIMD_INLINE Lanes squareRoot(Lanes square)
{
    constexpr int count = static_cast<int>(sizeof(Lanes) / sizeof(float));
    float roots[count];
    std::memcpy(roots, &square, sizeof roots);
    for (float& root : roots)
        root = std::sqrt(root);
    Lanes result;
    std::memcpy(&result, roots, sizeof roots);
    return result;
}

/// The light on a gradient that is seen so, right, down and away from the eye, as that of a surface across it
/// (shading.h). Where no gradient tells, the colour is left as it is. `leastSquare`: of gradients that tell.
template <class Lanes> TETRA_SIMD_INLINE void lightOnGradient(Lanes right, Lanes down, Lanes away, float leastSquare,
                                                              const LitRays<Lanes>& rays, LightThere<Lanes>& light)
{
    const Lanes along = right * rays.right + down * rays.down + away;
    const Lanes square = right * right + down * down + away * away;
    const auto known = square > leastSquare;
    const Lanes ones = Lanes{} + 1.0f;
    const Lanes scale = 1.0f / squareRoot(known ? square : ones);
    const Lanes towards = along > 0 ? -scale : scale;
    const Lanes cosine = smaller(-along * towards / rays.ray, ones);
    const Falling<Lanes> falling = lightOn<Lanes>(right * towards, -down * towards, -away * towards, cosine);
    light.factor = known ? falling.factor : ones;
    light.highlight = known ? falling.highlight : Lanes{};
    light.share = ones;
    if (rays.perFullGradient > 0)
        light.share = smaller(squareRoot(square) * rays.perFullGradient, ones);
}

/// The light at places w of rays through a cell.
template <bool perspective, class Lanes>
TETRA_SIMD_INLINE void lightAt(const CellLight& light, const LitRays<Lanes>& rays, Lanes w, LightThere<Lanes>& there)
{
    constexpr float leastSquare = 1e-12f; // of a gradient, of the longest
    Lanes components[3];
    for (int i = 0; i < 3; ++i) {
        const AffineFunction& of = light.components[i];
        const Lanes slope = of.a * rays.x + (of.b * rays.y + of.c);
        components[i] = perspective ? slope * w + of.more : slope - of.more * w;
    }
    lightOnGradient(components[0], components[1], components[2], leastSquare, rays, there);
}

/// The light is taken where a ray comes in and goes out, and is affine between.
template <bool perspective, class Lanes> TETRA_SIMD_INLINE LightAlong<Lanes>
lightAlong(const CellLight& light, const LitRays<Lanes>& lit, const CellRays<Lanes>& rays)
{
    LightThere<Lanes> in, out;
    lightAt<perspective>(light, lit, rays.enter, in);
    lightAt<perspective>(light, lit, rays.leave, out);
    return {in.factor, out.factor - in.factor, in.highlight, out.highlight - in.highlight,
            in.share,  out.share - in.share};
}

/// `lightOf` gives the light of the rays, when it is known where they come in and go out.
template <bool perspective, class Lanes, class LightOf>
TETRA_SIMD_INLINE void shadeUnder(CellRays<Lanes>& rays, const CellSetup& cell, const ScaledSegment* segments,
                                  Gathered<Lanes>& gathered, const LightOf& lightOf)
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
    const auto light = lightOf();
    if (cell.simple)
        addSlab(gathered, segments[cell.firstSegment], cell.thickness, valueIn, valueOut, length, light, Lanes{}, ones);
    else
        addSlices(gathered, segments, cell, valueIn, valueOut, length, light);
}

template <bool perspective, class Lanes> TETRA_SIMD_INLINE void
shade(CellRays<Lanes>& rays, const CellSetup& cell, const ScaledSegment* segments, Gathered<Lanes>& gathered)
{
    shadeUnder<perspective>(rays, cell, segments, gathered, [] { return NoLight(); });
}

/// A cell with CellSetup::light.
template <bool perspective, class Lanes>
TETRA_SIMD_INLINE void shadeLit(CellRays<Lanes>& rays, const CellSetup& cell, const ScaledSegment* segments,
                                Gathered<Lanes>& gathered, const LitRays<Lanes>& lit)
{
    shadeUnder<perspective>(
        rays, cell, segments,
        gathered, [&]() __attribute__((always_inline)) { return lightAlong<perspective>(*cell.light, lit, rays); });
}

/// Shades blocks that a cell covers. For use inside functions compiled for several instruction sets.

/// A block that a cell covers, to be shaded.
struct CoveredBlock {
    Float8 front, back, slope;
    SampleBlock* block;
    const CellSetup* cell;
    BlockLimits* meets; ///< the block's, if one of its rays meets a surface in the cell or before it
    float x, y;         ///< of its first sample in the tile; of KernelFeatures::Lit
};

inline constexpr Float8 laneX = {0, 1, 2, 3, 0, 1, 2, 3};
inline constexpr Float8 laneY = {0, 0, 0, 0, 1, 1, 1, 1};

/// What is drawn beside the cells' own slabs.
enum class KernelFeatures {
    None,
    Depth,
    All, ///< depth, surfaces, clip planes
    Lit, ///< these, and light
};

/// Surfaces and clip planes.
constexpr bool hasLimits(KernelFeatures extras)
{
    return extras == KernelFeatures::All || extras == KernelFeatures::Lit;
}

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
TETRA_SIMD_INLINE void shadeOne(const CoveredBlock& covered, const TileShading& shading)
{
    SampleBlock& block = *covered.block;
    CellRays<Float8> rays = {covered.front, covered.back, covered.slope, block.ray, {}, {}};
    Gathered<Float8> gathered = {block.red, block.green, block.blue, block.transmittance};
    if constexpr (extras == KernelFeatures::Lit)
        shadeLit<perspective>(rays, *covered.cell, shading.segments, gathered,
                              litRays(shading, laneX + covered.x, laneY + covered.y, block.ray));
    else
        shade<perspective>(rays, *covered.cell, shading.segments, gathered);
    if (extras == KernelFeatures::Depth || (hasLimits(extras) && shading.depth))
        keepDepth(block, 0, gathered.transmittance, rays.enter, rays.leave);
    store(block, gathered.red, gathered.green, gathered.blue, gathered.transmittance);
}

template <bool perspective, KernelFeatures extras>
TETRA_SIMD_INLINE void shadeHalves(const CoveredBlock& covered, const TileShading& shading)
{
    SampleBlock& block = *covered.block;
    const Halves front = halvesOf(covered.front), back = halvesOf(covered.back), slope = halvesOf(covered.slope);
    const Halves ray = halvesOf(block.ray), left = halvesOf(block.transmittance);
    const Halves red = halvesOf(block.red), green = halvesOf(block.green), blue = halvesOf(block.blue);
    CellRays<Float4> rays[2] = {{front.low, back.low, slope.low, ray.low, {}, {}},
                                {front.high, back.high, slope.high, ray.high, {}, {}}};
    Gathered<Float4> gathered[2] = {{red.low, green.low, blue.low, left.low},
                                    {red.high, green.high, blue.high, left.high}};
    for (int half = 0; half < 2; ++half)
        if constexpr (extras == KernelFeatures::Lit) {
            const Float4 x = Float4{0, 1, 2, 3} + covered.x, y = Float4{} + (covered.y + static_cast<float>(half));
            shadeLit<perspective>(rays[half], *covered.cell, shading.segments, gathered[half],
                                  litRays(shading, x, y, half == 0 ? ray.low : ray.high));
        } else
            shade<perspective>(rays[half], *covered.cell, shading.segments, gathered[half]);
    if (extras == KernelFeatures::Depth || (hasLimits(extras) && shading.depth))
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

/// Two blocks of one cell.
template <bool perspective, KernelFeatures extras>
TETRA_SIMD_INLINE void shadeTwo(const CoveredBlock& one, const CoveredBlock& other, const TileShading& shading)
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
    if constexpr (extras == KernelFeatures::Lit) {
        const Float16 x = joined(laneX + one.x, laneX + other.x), y = joined(laneY + one.y, laneY + other.y);
        shadeLit<perspective>(rays, *one.cell, shading.segments, gathered, litRays(shading, x, y, rays.ray));
    } else
        shade<perspective>(rays, *one.cell, shading.segments, gathered);
    if (extras == KernelFeatures::Depth || (hasLimits(extras) && shading.depth)) {
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
template <bool perspective, KernelFeatures extras, class Lanes>
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
        Gathered<Lanes> gathered = {lanesOf<Lanes>(block.red, first), lanesOf<Lanes>(block.green, first),
                                    lanesOf<Lanes>(block.blue, first), before};
        if constexpr (extras == KernelFeatures::Lit)
            shadeLit<perspective>(rays, *covered.cell, shading.segments, gathered,
                                  litRays(shading, lanesOf<Lanes>(laneX + covered.x, first),
                                          lanesOf<Lanes>(laneY + covered.y, first), ray));
        else
            shade<perspective>(rays, *covered.cell, shading.segments, gathered);
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
