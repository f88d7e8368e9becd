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

/// What has reached the eye of a block's rays so far.
struct Gathered {
    Float8 red, green, blue, light;
};

/// Adds a slab whose optical depth is at most 1, or faintDepth; values count from the segment's origin.
template <bool faint> [[gnu::always_inline]] inline void addThinSlab(Gathered& gathered, const ScaledSegment& segment,
                                                                     Float8 valueIn, Float8 valueOut, Float8 length)
{
    const Float8 in = segment.halfExtinction + segment.halfExtinctionPerValue * valueIn;
    const Float8 out = segment.halfExtinction + segment.halfExtinctionPerValue * valueOut;
    const Float8 depth = larger(length * (in + out), Float8{});
    SlabLight slab;
    if constexpr (faint)
        faintSlabLight(depth, length * (out - in), slab);
    else
        slabLight(depth, length * (out - in), slab);
    const Float8 opacity = slab.opacity * gathered.light;
    const Float8 weight = slab.weight * gathered.light;
    const Float8 value = valueIn * opacity + (valueOut - valueIn) * weight;
    gathered.red += segment.colour[0] * opacity + segment.colourPerValue[0] * value;
    gathered.green += segment.colour[1] * opacity + segment.colourPerValue[1] * value;
    gathered.blue += segment.colour[2] * opacity + segment.colourPerValue[2] * value;
    gathered.light -= opacity;
}

/// Adds a slab of any optical depth, cut into thin ones.
[[gnu::always_inline]] inline void addThickSlab(Gathered& gathered, const ScaledSegment& segment, Float8 valueIn,
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
        addThinSlab<false>(gathered, segment, valueIn + i * step, valueIn + (i + 1) * step, part);
}

[[gnu::always_inline]] inline void addSlab(Gathered& gathered, const ScaledSegment& segment, Thickness thickness,
                                           Float8 valueIn, Float8 valueOut, Float8 length)
{
    if (thickness == Thickness::Faint)
        addThinSlab<true>(gathered, segment, valueIn, valueOut, length);
    else if (thickness == Thickness::Thin)
        addThinSlab<false>(gathered, segment, valueIn, valueOut, length);
    else
        addThickSlab(gathered, segment, valueIn, valueOut, length);
}

/// Adds the slabs of rays that meet a cell's segments upwards, or downwards.
[[gnu::always_inline]] inline void addSlicesOneWay(Gathered& gathered, const ScaledSegment* segments,
                                                   const CellSetup& cell, bool upwards, Float8 valueIn, Float8 rise,
                                                   Float8 perRise, Float8 length)
{
    Float8 shareBefore = {};
    Float8 from = valueIn;
    for (int i = 0; i <= cell.lastSegment - cell.firstSegment; ++i) {
        const ScaledSegment& segment = segments[upwards ? cell.firstSegment + i : cell.lastSegment - i];
        const float knot = upwards ? segment.end : segment.begin;
        const Float8 share = smaller(larger((knot - valueIn) * perRise, Float8{}), Float8{} + 1.0f);
        const Float8 to = valueIn + share * rise;
        if (!segment.transparent)
            addSlab(gathered, segment, cell.thickness, from - segment.origin, to - segment.origin,
                    length * (share - shareBefore));
        shareBefore = share;
        from = to;
    }
}

/// Adds the part of a ray through a cell with the knots of several segments: a slab for each, in the order in which the
/// ray meets them (R22).
[[gnu::always_inline]] inline void addSlices(Gathered& gathered, const ScaledSegment* segments, const CellSetup& cell,
                                             Float8 valueIn, Float8 valueOut, Float8 length)
{
    const Float8 lowest = Float8{} + cell.smallest;
    const Float8 highest = Float8{} + cell.largest;
    valueIn = smaller(larger(valueIn, lowest), highest);
    valueOut = smaller(larger(valueOut, lowest), highest);
    const Float8 rise = valueOut - valueIn;
    // Where the value hardly changes, the whole ray goes to the segment of its start.
    constexpr float levelRise = 1e-8f;
    const bool down = cell.direction == Direction::Falling;
    const Int8 level = (rise < levelRise) & (rise > -levelRise);
    const Float8 perRise = 1.0f / (level ? Float8{} + (down ? -levelRise : levelRise) : rise);
    if (cell.direction != Direction::Mixed)
        return addSlicesOneWay(gathered, segments, cell, !down, valueIn, rise, perRise, length);
    const Int8 falls = perRise < 0.0f;
    addSlicesOneWay(gathered, segments, cell, true, valueIn, rise, perRise, falls ? Float8{} : length);
    if (any(falls & (length > 0.0f)))
        addSlicesOneWay(gathered, segments, cell, false, valueIn, rise, perRise, falls ? length : Float8{});
}

[[gnu::always_inline]] inline Float8 atLanes(const AffineFunction& function, float x, float y)
{
    return function.a * (laneX + x) + (function.b * (laneY + y) + function.c);
}

/// Marks where the light fell to a half inside a cell.
[[gnu::always_inline]] inline void keepDepth(SampleBlock& block, Float8 light, Float8 enter, Float8 leave)
{
    const Int8 here = (block.light > 0.5f) & (light <= 0.5f);
    if (!any(here))
        return;
    for (int lane = 0; lane < 8; ++lane)
        if (here[lane] != 0) {
            const float left = std::max(light[lane], 1e-12f);
            const float share = std::log(2 * block.light[lane]) / std::log(block.light[lane] / left);
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
    Gathered gathered = {block.red, block.green, block.blue, block.light};
    if (cell.simple)
        addSlab(gathered, shading.segments[cell.firstSegment], cell.thickness, valueIn, valueOut, length);
    else
        addSlices(gathered, shading.segments, cell, valueIn, valueOut, length);
    if constexpr (depth)
        keepDepth(block, gathered.light, enter, leave);
    block.red = gathered.red;
    block.green = gathered.green;
    block.blue = gathered.blue;
    block.light = gathered.light;
}

/// The columns of blocks that a wide cell covers in each row of them. A sample is covered if all bounds of fronts lie
/// above all bounds of backs there; each such pair is a half-plane, and there are four at most.
class CoveredColumns {
public:
    CoveredColumns() = default;
    [[gnu::always_inline]] explicit CoveredColumns(const CellSetup& cell)
    {
        const bool oneFront = cell.functions[1].c == farBound;
        const bool oneBack = cell.functions[4].c == -farBound;
        for (int i = 0; i < 4; ++i) {
            const AffineFunction& front = cell.functions[oneFront ? 0 : oneBack ? i % 3 : i / 2];
            const AffineFunction& back = cell.functions[3 + (oneFront ? i % 3 : oneBack ? 0 : i % 2)];
            perX_[i] = front.a - back.a;
            perY_[i] = front.b - back.b;
            atOrigin_[i] = front.c - back.c;
        }
        const Int4 rising = perX_ > 0.0f;
        const Int4 falling = perX_ < 0.0f;
        // Where a half-plane has no end on a side, this puts it far away.
        const Float4 reciprocal = -1.0f / (rising | falling ? perX_ : Float4{} + 1.0f);
        toLeft_ = rising ? reciprocal : Float4{};
        toRight_ = falling ? reciprocal : Float4{};
        leftEnd_ = rising ? Float4{} - margin : Float4{} - farAway;
        rightEnd_ = falling ? Float4{} + margin : Float4{} + farAway;
    }

    /// Narrows [left, right) for a row of blocks.
    [[gnu::always_inline]] void narrow(int row, int& left, int& right) const
    {
        const Float4 top = atOrigin_ + perY_ * static_cast<float>(row * blockHeight);
        const Float4 bottom = top + perY_ * (blockHeight - 1);
        const Float4 highest = top > bottom ? top : bottom;
        const Float4 from = highest * toLeft_ + leftEnd_;
        const Float4 to = highest * toRight_ + rightEnd_;
        const float first = std::max(std::max(from[0], from[1]), std::max(from[2], from[3]));
        const float last = std::min(std::min(to[0], to[1]), std::min(to[2], to[3]));
        left = std::max(left, static_cast<int>(std::clamp(first, 0.0f, farAway)) / blockWidth);
        right = std::min(right, (static_cast<int>(std::clamp(last, -1.0f, farAway) + 1) + blockWidth - 1) / blockWidth);
    }

private:
    static constexpr float margin = 0.05f;
    static constexpr float farAway = 1e6f;
    Float4 perX_, perY_, atOrigin_;
    Float4 toLeft_, toRight_, leftEnd_, rightEnd_;
};

/// A block that a cell covers, to be shaded.
struct CoveredBlock {
    Float8 front, back, slope;
    SampleBlock* block;
    const CellSetup* cell;
};

/// Blocks are first found and then shaded, many at a time: whether a block is covered is hard to predict, and a wrong
/// guess costs as much as half the shading.
template <bool perspective, bool depth> class BlockQueue {
public:
    [[gnu::always_inline]] BlockQueue(const TileShading& shading, SampleBlock* blocks, int columns)
        : shading_(shading), blocks_(blocks), columns_(columns)
    {
    }

    [[gnu::always_inline]] void add(const CellSetup& cell)
    {
        const float x = static_cast<float>(cell.left * blockWidth);
        const float y = static_cast<float>(cell.top * blockHeight);
        Float8 rows[7];
        float right[7], down[7];
        for (int i = 0; i < 7; ++i) {
            rows[i] = atLanes(cell.functions[i], x, y);
            right[i] = cell.functions[i].a * blockWidth;
            down[i] = cell.functions[i].b * blockHeight;
        }
        const int width = cell.right - cell.left;
        const bool wide = width >= wideCell && !cell.around;
        const CoveredColumns covered = wide ? CoveredColumns(cell) : CoveredColumns();
        for (int row = cell.top; row < cell.bottom; ++row) {
            int left = cell.left, end = cell.right;
            Float8 now[7];
            for (int i = 0; i < 7; ++i)
                now[i] = rows[i];
            if (wide) {
                covered.narrow(row, left, end);
                for (int i = 0; i < 7; ++i)
                    now[i] += right[i] * static_cast<float>(left - cell.left);
            }
            addRow(cell, now, right, blocks_ + row * columns_ + left, end - left);
            for (int i = 0; i < 7; ++i)
                rows[i] += down[i];
        }
    }

    [[gnu::always_inline]] void shade()
    {
        for (int i = 0; i < count_; ++i) {
            const CoveredBlock& one = queue_[i];
            shadeBlock<perspective, depth>(*one.block, *one.cell, shading_, one.front > one.back, one.front, one.back,
                                           one.slope);
        }
        count_ = 0;
    }

private:
    /// Cells with fewer columns of blocks are tested block by block.
    static constexpr int wideCell = 4;
    static constexpr int capacity = 128;
    static constexpr int longestRow = 64;

    [[gnu::always_inline]] void addRow(const CellSetup& cell, Float8 (&now)[7], const float (&right)[7],
                                       SampleBlock* block, int count)
    {
        if (count_ > capacity - longestRow)
            shade();
        for (; count > 0; --count, ++block) {
            CoveredBlock& next = queue_[count_];
            next.front = smaller(smaller(now[0], now[1]), smaller(now[2], Float8{} + shading_.nearestBound));
            next.back = larger(larger(now[3], now[4]), now[5]);
            if (cell.around) [[unlikely]] {
                next.front = Float8{} + shading_.nearestBound;
                next.back = larger(next.back, now[0]);
            }
            next.slope = now[6];
            next.block = block;
            next.cell = &cell;
            count_ += any((next.front > next.back) & (block->light > darkness)) ? 1 : 0;
            for (int i = 0; i < 7; ++i)
                now[i] += right[i];
        }
    }

    const TileShading& shading_;
    SampleBlock* blocks_;
    int columns_;
    int count_ = 0;
    CoveredBlock queue_[capacity + 1];
};

template <bool perspective, bool depth> [[gnu::always_inline]] inline void
drawAll(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
    BlockQueue<perspective, depth> queue(shading, blocks, columns);
    for (const CellSetup& cell : cells)
        if (!cell.flat)
            queue.add(cell);
    queue.shade();
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
