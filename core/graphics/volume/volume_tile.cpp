// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/volume_tile.h"

#include "core/graphics/volume/slab_integral.h"

#include <algorithm>
#include <cmath>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace tetra {
namespace {

static_assert(blockWidth == 4 && blockHeight == 2, "lanes are named by their place in the block");
constexpr Float8 laneX = {0, 1, 2, 3, 0, 1, 2, 3};
constexpr Float8 laneY = {0, 0, 0, 0, 1, 1, 1, 1};

/// Beyond this optical depth nothing of a slab is seen.
constexpr float deepest = 24;

[[gnu::always_inline]] inline Float8 smaller(Float8 a, Float8 b)
{
    return a < b ? a : b;
}
[[gnu::always_inline]] inline Float8 larger(Float8 a, Float8 b)
{
    return a > b ? a : b;
}

[[gnu::always_inline]] inline bool any(Int8 mask)
{
    const Int4 low = __builtin_shufflevector(mask, mask, 0, 1, 2, 3);
    const Int4 high = __builtin_shufflevector(mask, mask, 4, 5, 6, 7);
    const Int4 both = low | high;
#if defined(__SSE2__)
    return _mm_movemask_ps((__m128)both) != 0;
#else
    return (both[0] | both[1] | both[2] | both[3]) != 0;
#endif
}

/// Adds a slab whose optical depth is at most 1; values count from the segment's origin.
[[gnu::always_inline]] inline void addThinSlab(SampleBlock& block, const ScaledSegment& segment, Float8 valueIn,
                                               Float8 valueOut, Float8 length)
{
    const Float8 in = segment.halfExtinction + segment.halfExtinctionPerValue * valueIn;
    const Float8 out = segment.halfExtinction + segment.halfExtinctionPerValue * valueOut;
    SlabLight slab;
    slabLight(larger(length * (in + out), Float8{}), length * (out - in), slab);
    const Float8 opacity = slab.opacity * block.light;
    const Float8 weight = slab.weight * block.light;
    const Float8 value = valueIn * opacity + (valueOut - valueIn) * weight;
    block.red += segment.colour[0] * opacity + segment.colourPerValue[0] * value;
    block.green += segment.colour[1] * opacity + segment.colourPerValue[1] * value;
    block.blue += segment.colour[2] * opacity + segment.colourPerValue[2] * value;
    block.light -= opacity;
}

/// Adds a slab of any optical depth, cut into thin ones.
[[gnu::always_inline]] inline void addThickSlab(SampleBlock& block, const ScaledSegment& segment, Float8 valueIn,
                                                Float8 valueOut, Float8 length)
{
    const Float8 in = segment.halfExtinction + segment.halfExtinctionPerValue * valueIn;
    const Float8 out = segment.halfExtinction + segment.halfExtinctionPerValue * valueOut;
    float parts = 1;
    for (int lane = 0; lane < 8; ++lane) {
        // With s from 0 to 1 along the slab the optical depth before s is s (atStart + s rise).
        const float atStart = std::max(2 * length[lane] * in[lane], 0.0f);
        const float rise = length[lane] * (out[lane] - in[lane]);
        float share = 1;
        if (atStart + rise > deepest) {
            share = 2 * deepest / (atStart + std::sqrt(std::max(atStart * atStart + 4 * rise * deepest, 0.0f)));
            share = std::min(share, 1.0f);
            length[lane] *= share;
            valueOut[lane] = valueIn[lane] + share * (valueOut[lane] - valueIn[lane]);
        }
        parts = std::max({parts, share * atStart, share * (atStart + 2 * share * rise)});
    }
    const float count = std::ceil(parts);
    const Float8 step = (valueOut - valueIn) * (1 / count);
    const Float8 part = length * (1 / count);
    for (float i = 0; i < count; ++i)
        addThinSlab(block, segment, valueIn + i * step, valueIn + (i + 1) * step, part);
}

[[gnu::always_inline]] inline void addSlab(SampleBlock& block, const ScaledSegment& segment, bool thick, Float8 valueIn,
                                           Float8 valueOut, Float8 length)
{
    if (thick) [[unlikely]]
        addThickSlab(block, segment, valueIn, valueOut, length);
    else
        addThinSlab(block, segment, valueIn, valueOut, length);
}

/// Adds the part of a ray through a cell with the knots of several segments: a slab for each, in the order in which the
/// ray meets them (R22).
[[gnu::always_inline]] inline void addSlices(SampleBlock& block, const ScaledSegment* segments, const CellSetup& cell,
                                             Float8 valueIn, Float8 valueOut, Float8 length)
{
    const Float8 lowest = Float8{} + cell.smallest;
    const Float8 highest = Float8{} + cell.largest;
    valueIn = smaller(larger(valueIn, lowest), highest);
    valueOut = smaller(larger(valueOut, lowest), highest);
    const Float8 rise = valueOut - valueIn;
    const Int8 level = rise == 0.0f;
    const Float8 perRise = 1.0f / (level ? Float8{} + 1.0f : rise);
    const Int8 inside = length > 0.0f;
    for (const bool upwards : {true, false}) {
        const Int8 mask = inside & (upwards ? (rise >= 0.0f) : (rise < 0.0f));
        if (!any(mask))
            continue;
        for (int i = 0; i <= cell.lastSegment - cell.firstSegment; ++i) {
            const ScaledSegment& segment = segments[upwards ? cell.firstSegment + i : cell.lastSegment - i];
            if (segment.transparent)
                continue;
            const Float8 begin = Float8{} + segment.begin;
            const Float8 end = Float8{} + segment.end;
            const Float8 from = smaller(larger(valueIn, begin), end);
            const Float8 to = smaller(larger(valueOut, begin), end);
            const Int8 levelHere = level & (valueIn >= begin) & (valueIn < end);
            const Float8 share = levelHere ? Float8{} + 1.0f : (to - from) * perRise;
            const Float8 part = mask ? length * share : Float8{};
            addSlab(block, segment, cell.thick, from - segment.origin, to - segment.origin, part);
        }
    }
}

[[gnu::always_inline]] inline Float8 atLanes(const AffineFunction& function, float x, float y)
{
    return function.a * (laneX + x) + (function.b * (laneY + y) + function.c);
}

/// Marks where the light fell to a half inside a cell.
[[gnu::always_inline]] inline void keepDepth(SampleBlock& block, Float8 lightBefore, Float8 enter, Float8 leave)
{
    const Int8 here = (lightBefore > 0.5f) & (block.light <= 0.5f);
    if (!any(here))
        return;
    for (int lane = 0; lane < 8; ++lane)
        if (here[lane] != 0) {
            const float left = std::max(block.light[lane], 1e-12f);
            const float share = std::log(2 * lightBefore[lane]) / std::log(lightBefore[lane] / left);
            block.depth[lane] = enter[lane] + share * (leave[lane] - enter[lane]);
        }
}

template <bool perspective, bool depth>
[[gnu::always_inline]] inline void shadeBlock(SampleBlock& block, const CellSetup& cell, const TileShading& shading,
                                              Int8 inside, Float8 front, Float8 back, Float8 slope)
{
    const Float8 ones = Float8{} + 1.0f;
    front = inside ? front : ones;
    back = inside ? back : ones;
    Float8 enter, leave, valueIn, valueOut;
    if constexpr (perspective) {
        const Float8 both = 1.0f / (front * back);
        enter = back * both;
        leave = front * both;
        valueIn = slope * enter + cell.constant;
        valueOut = slope * leave + cell.constant;
    } else {
        enter = -front;
        leave = -back;
        valueIn = slope + cell.constant * front;
        valueOut = slope + cell.constant * back;
    }
    const Float8 length = (leave - enter) * block.ray;
    const Float8 lightBefore = block.light;
    if (cell.simple)
        addSlab(block, shading.segments[cell.firstSegment], cell.thick, valueIn, valueOut, length);
    else
        addSlices(block, shading.segments, cell, valueIn, valueOut, length);
    if constexpr (depth)
        keepDepth(block, lightBefore, enter, leave);
}

template <bool perspective, bool depth> [[gnu::always_inline]] inline void
drawCell(const CellSetup& cell, const TileShading& shading, SampleBlock* blocks, int columns)
{
    const float x = static_cast<float>(cell.left * blockWidth);
    const float y = static_cast<float>(cell.top * blockHeight);
    Float8 rows[7];
    float right[7], down[7];
    const auto start = [&](int i, const AffineFunction& function) __attribute__((always_inline))
    {
        rows[i] = atLanes(function, x, y);
        right[i] = function.a * blockWidth;
        down[i] = function.b * blockHeight;
    };
    for (int i = 0; i < 3; ++i) {
        start(i, cell.fronts[i]);
        start(i + 3, cell.backs[i]);
    }
    start(6, cell.slope);
    for (int row = cell.top; row < cell.bottom; ++row) {
        Float8 now[7];
        for (int i = 0; i < 7; ++i)
            now[i] = rows[i];
        SampleBlock* block = blocks + row * columns + cell.left;
        for (int column = cell.left; column < cell.right; ++column, ++block) {
            Float8 front = smaller(smaller(now[0], now[1]), smaller(now[2], Float8{} + shading.nearestBound));
            Float8 back = larger(larger(now[3], now[4]), now[5]);
            if (cell.around) [[unlikely]] {
                front = Float8{} + shading.nearestBound;
                back = larger(back, now[0]);
            }
            const Int8 inside = (front > back) & (block->light > darkness);
            if (any(inside))
                shadeBlock<perspective, depth>(*block, cell, shading, inside, front, back, now[6]);
            for (int i = 0; i < 7; ++i)
                now[i] += right[i];
        }
        for (int i = 0; i < 7; ++i)
            rows[i] += down[i];
    }
}

template <bool perspective, bool depth> [[gnu::always_inline]] inline void
drawAll(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
    for (const CellSetup& cell : cells)
        if (!cell.flat)
            drawCell<perspective, depth>(cell, shading, blocks, columns);
}

TETRA_SIMD_CLONES void drawPerspective(std::span<const CellSetup> cells, const TileShading& shading,
                                       SampleBlock* blocks, int columns)
{
    drawAll<true, false>(cells, shading, blocks, columns);
}
TETRA_SIMD_CLONES void drawPerspectiveDepth(std::span<const CellSetup> cells, const TileShading& shading,
                                            SampleBlock* blocks, int columns)
{
    drawAll<true, true>(cells, shading, blocks, columns);
}
TETRA_SIMD_CLONES void drawOrthographic(std::span<const CellSetup> cells, const TileShading& shading,
                                        SampleBlock* blocks, int columns)
{
    drawAll<false, false>(cells, shading, blocks, columns);
}
TETRA_SIMD_CLONES void drawOrthographicDepth(std::span<const CellSetup> cells, const TileShading& shading,
                                             SampleBlock* blocks, int columns)
{
    drawAll<false, true>(cells, shading, blocks, columns);
}

} // namespace

void drawCells(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
    if (shading.perspective)
        (shading.depth ? drawPerspectiveDepth : drawPerspective)(cells, shading, blocks, columns);
    else
        (shading.depth ? drawOrthographicDepth : drawOrthographic)(cells, shading, blocks, columns);
}

} // namespace tetra
