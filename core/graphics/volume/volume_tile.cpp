// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/volume_tile.h"

#include "core/graphics/volume/slab_shading.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tetra {
namespace {

static_assert(blockWidth == 4 && blockHeight == 2, "lanes are named by their place in the block");
constexpr Float8 laneX = {0, 1, 2, 3, 0, 1, 2, 3};
constexpr Float8 laneY = {0, 0, 0, 0, 1, 1, 1, 1};

TETRA_SIMD_INLINE Float8 atLanes(const AffineFunction& function, float x, float y)
{
    return function.a * (laneX + x) + (function.b * (laneY + y) + function.c);
}

/// Marks where the light fell to a half inside a cell.
TETRA_SIMD_INLINE void keepDepth(SampleBlock& block, Float8 light, Float8 enter, Float8 leave)
{
    for (int lane = 0; lane < 8; ++lane)
        if (block.light[lane] > 0.5f && light[lane] <= 0.5f) {
            const float left = std::max(light[lane], 1e-12f);
            const float share = std::log(2 * block.light[lane]) / std::log(block.light[lane] / left);
            block.depth[lane] = enter[lane] + share * (leave[lane] - enter[lane]);
        }
}

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

TETRA_SIMD_INLINE void store(SampleBlock& block, Float8 red, Float8 green, Float8 blue, Float8 light)
{
    block.red = red;
    block.green = green;
    block.blue = blue;
    block.light = light;
}

/// A block that a cell covers, to be shaded.
struct CoveredBlock {
    Float8 front, back, slope;
    SampleBlock* block;
    const CellSetup* cell;
};

/// The halves of a block's vector; through memory, as machines without such vectors have it there.
struct Halves {
    Float4 low, high;
};
TETRA_SIMD_INLINE Halves halvesOf(Float8 lanes)
{
    return std::bit_cast<Halves>(lanes);
}
TETRA_SIMD_INLINE Float8 whole(Float4 low, Float4 high)
{
    return std::bit_cast<Float8>(Halves{low, high});
}

template <bool perspective, bool depth>
TETRA_SIMD_INLINE void shadeOne(const CoveredBlock& covered, const ScaledSegment* segments)
{
    SampleBlock& block = *covered.block;
    CellRays<Float8> rays = {covered.front, covered.back, covered.slope, block.ray, {}, {}};
    Gathered<Float8> gathered = {block.red, block.green, block.blue, block.light};
    shade<perspective>(rays, *covered.cell, segments, gathered);
    if constexpr (depth)
        keepDepth(block, gathered.light, rays.enter, rays.leave);
    store(block, gathered.red, gathered.green, gathered.blue, gathered.light);
}

template <bool perspective, bool depth>
TETRA_SIMD_INLINE void shadeHalves(const CoveredBlock& covered, const ScaledSegment* segments)
{
    SampleBlock& block = *covered.block;
    const Halves front = halvesOf(covered.front), back = halvesOf(covered.back), slope = halvesOf(covered.slope);
    const Halves ray = halvesOf(block.ray), light = halvesOf(block.light);
    const Halves red = halvesOf(block.red), green = halvesOf(block.green), blue = halvesOf(block.blue);
    CellRays<Float4> rays[2] = {{front.low, back.low, slope.low, ray.low, {}, {}},
                                {front.high, back.high, slope.high, ray.high, {}, {}}};
    Gathered<Float4> gathered[2] = {{red.low, green.low, blue.low, light.low},
                                    {red.high, green.high, blue.high, light.high}};
    for (int half = 0; half < 2; ++half)
        shade<perspective>(rays[half], *covered.cell, segments, gathered[half]);
    if constexpr (depth)
        keepDepth(block, whole(gathered[0].light, gathered[1].light), whole(rays[0].enter, rays[1].enter),
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

/// Two blocks of one cell.
template <bool perspective, bool depth>
TETRA_SIMD_INLINE void shadeTwo(const CoveredBlock& one, const CoveredBlock& other, const ScaledSegment* segments)
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
    if constexpr (depth) {
        keepDepth(a, lowHalf(gathered.light), lowHalf(rays.enter), lowHalf(rays.leave));
        keepDepth(b, highHalf(gathered.light), highHalf(rays.enter), highHalf(rays.leave));
    }
    store(a, lowHalf(gathered.red), lowHalf(gathered.green), lowHalf(gathered.blue), lowHalf(gathered.light));
    store(b, highHalf(gathered.red), highHalf(gathered.green), highHalf(gathered.blue), highHalf(gathered.light));
}

/// The columns of blocks that a wide cell covers in each row of them. A sample is covered if all bounds of fronts lie
/// above all bounds of backs there; each such pair is a half-plane, and there are four at most.
class CoveredColumns {
public:
    CoveredColumns() = default;
    TETRA_SIMD_INLINE explicit CoveredColumns(const CellSetup& cell)
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
    TETRA_SIMD_INLINE void narrow(int row, int& left, int& right) const
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

/// Where the rays of a block are inside a cell.
template <class Lanes> struct BlockTest {
    Lanes front, back;
    decltype(Lanes{} > Lanes{}) covered; ///< and light still comes through

    TETRA_SIMD_INLINE BlockTest(Lanes front0, Lanes front1, Lanes front2, Lanes back0, Lanes back1, Lanes back2,
                                Lanes light, float nearest, bool around)
        : front(smaller(smaller(front0, front1), smaller(front2, Lanes{} + nearest))),
          back(larger(larger(back0, back1), back2))
    {
        if (around) [[unlikely]] {
            front = Lanes{} + nearest;
            back = larger(back, front0);
        }
        covered = (front > back) & (light > darkness);
    }
};

/// Blocks are first found and then shaded, many at a time: whether a block is covered is hard to predict, and a wrong
/// guess costs as much as half the shading.
/// `lanes`: how many rays the machine does at a time, 4, 8 or 16.
template <bool perspective, bool depth, int lanes> class BlockQueue {
public:
    TETRA_SIMD_INLINE BlockQueue(const TileShading& shading, SampleBlock* blocks, int columns)
        : shading_(shading), blocks_(blocks), columns_(columns)
    {
    }

    TETRA_SIMD_INLINE void add(const CellSetup& cell)
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

    TETRA_SIMD_INLINE void shade()
    {
        int i = 0;
        while (i < count_) {
            const CoveredBlock* next = queue_ + i;
            if constexpr (lanes == 16)
                if (i + 1 < count_ && next[0].cell == next[1].cell) {
                    shadeTwo<perspective, depth>(next[0], next[1], shading_.segments);
                    i += 2;
                    continue;
                }
            if constexpr (lanes == 4)
                shadeHalves<perspective, depth>(*next, shading_.segments);
            else
                shadeOne<perspective, depth>(*next, shading_.segments);
            ++i;
        }
        count_ = 0;
    }

private:
    /// Cells with fewer columns of blocks are tested block by block.
    static constexpr int wideCell = 4;
    static constexpr int capacity = 128;
    static constexpr int longestRow = 64;

    TETRA_SIMD_INLINE void addRow(const CellSetup& cell, Float8 (&now)[7], const float (&right)[7], SampleBlock* block,
                                  int count)
    {
        if (count_ > capacity - longestRow)
            shade();
        for (; count > 0; --count, ++block) {
            CoveredBlock& next = queue_[count_];
            bool covers;
            if constexpr (lanes == 4) {
                Halves parts[6];
                for (int i = 0; i < 6; ++i)
                    parts[i] = halvesOf(now[i]);
                const Halves light = halvesOf(block->light);
                const BlockTest<Float4> low(parts[0].low, parts[1].low, parts[2].low, parts[3].low, parts[4].low,
                                            parts[5].low, light.low, shading_.nearestBound, cell.around);
                const BlockTest<Float4> high(parts[0].high, parts[1].high, parts[2].high, parts[3].high, parts[4].high,
                                             parts[5].high, light.high, shading_.nearestBound, cell.around);
                next.front = whole(low.front, high.front);
                next.back = whole(low.back, high.back);
                covers = any(low.covered | high.covered);
            } else {
                const BlockTest<Float8> test(now[0], now[1], now[2], now[3], now[4], now[5], block->light,
                                             shading_.nearestBound, cell.around);
                next.front = test.front;
                next.back = test.back;
                covers = any(test.covered);
            }
            next.slope = now[6];
            next.block = block;
            next.cell = &cell;
            count_ += covers ? 1 : 0;
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

template <bool perspective, bool depth, int lanes> TETRA_SIMD_INLINE void
drawAll(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
    BlockQueue<perspective, depth, lanes> queue(shading, blocks, columns);
    for (const CellSetup& cell : cells)
        if (!cell.flat)
            queue.add(cell);
    queue.shade();
}

/// By projection and whether depth is wanted.
template <int lanes> TETRA_SIMD_INLINE void drawAny(std::span<const CellSetup> cells, const TileShading& shading,
                                                    SampleBlock* blocks, int columns)
{
    if (shading.perspective && !shading.depth)
        drawAll<true, false, lanes>(cells, shading, blocks, columns);
    else if (shading.perspective)
        drawAll<true, true, lanes>(cells, shading, blocks, columns);
    else if (!shading.depth)
        drawAll<false, false, lanes>(cells, shading, blocks, columns);
    else
        drawAll<false, true, lanes>(cells, shading, blocks, columns);
}

void drawByFours(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
    drawAny<4>(cells, shading, blocks, columns);
}

#if defined(TETRA_SIMD_16)
TETRA_SIMD_8 void drawByEights(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks,
                               int columns)
{
    drawAny<8>(cells, shading, blocks, columns);
}
TETRA_SIMD_16 void drawBySixteens(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks,
                                  int columns)
{
    drawAny<16>(cells, shading, blocks, columns);
}
#endif

} // namespace

void drawCells(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
#if defined(TETRA_SIMD_16)
    if (hasSimd16())
        return drawBySixteens(cells, shading, blocks, columns);
    if (hasSimd8())
        return drawByEights(cells, shading, blocks, columns);
#endif
    drawByFours(cells, shading, blocks, columns);
}

} // namespace tetra
