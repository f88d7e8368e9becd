// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/volume/block_shading.h"
#include "core/graphics/volume/covered_columns.h"
#include "core/graphics/volume/surface_shading.h"

namespace tetra {

static_assert(blockWidth == 4 && blockHeight == 2, "lanes are named by their place in the block");
constexpr Float8 laneX = {0, 1, 2, 3, 0, 1, 2, 3};
constexpr Float8 laneY = {0, 0, 0, 0, 1, 1, 1, 1};

TETRA_SIMD_INLINE Float8 atLanes(const AffineFunction& function, float x, float y)
{
    return function.a * (laneX + x) + (function.b * (laneY + y) + function.c);
}

/// Where the rays of a block are inside a cell.
template <class Lanes> struct BlockTest {
    Lanes front, back;
    decltype(Lanes{} > Lanes{}) covered; ///< and light still comes through

    TETRA_SIMD_INLINE BlockTest(Lanes front0, Lanes front1, Lanes front2, Lanes back0, Lanes back1, Lanes back2,
                                Lanes light, Lanes nearest, bool around)
        : front(smaller(smaller(front0, front1), smaller(front2, nearest))), back(larger(larger(back0, back1), back2))
    {
        if (around) [[unlikely]] {
            front = nearest;
            back = larger(back, front0);
        }
        covered = (front > back) & (light > darkness);
    }
};

/// Blocks are first found and then shaded, many at a time: whether a block is covered is hard to predict, and a wrong
/// guess costs as much as half the shading.
/// `lanes`: how many rays the machine does at a time, 4, 8 or 16.
template <bool perspective, Extras extras, int lanes> class BlockQueue {
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
            if constexpr (extras == Extras::All)
                if (next->meets != nullptr) {
                    shadeWithSurfaces(*next);
                    ++i;
                    continue;
                }
            if constexpr (lanes == 16)
                if (i + 1 < count_ && next[0].cell == next[1].cell &&
                    (extras != Extras::All || next[1].meets == nullptr)) {
                    shadeTwo<perspective, extras>(next[0], next[1], shading_.segments, shading_.depth);
                    i += 2;
                    continue;
                }
            if constexpr (lanes == 4)
                shadeHalves<perspective, extras>(*next, shading_.segments, shading_.depth);
            else
                shadeOne<perspective, extras>(*next, shading_.segments, shading_.depth);
            ++i;
        }
        shaded_ += static_cast<std::size_t>(count_);
        count_ = 0;
    }

    /// How many blocks were shaded.
    std::size_t shadedBlocks() const { return shaded_; }

private:
    /// Cells with fewer columns of blocks are tested block by block.
    static constexpr int wideCell = 4;
    static constexpr int capacity = 128;
    static constexpr int longestRow = 64;

    TETRA_SIMD_INLINE void shadeWithSurfaces(const CoveredBlock& covered) const
    {
        if constexpr (lanes == 4) {
            shadeAmongSurfaces<perspective, Float4>(covered, 0, shading_);
            shadeAmongSurfaces<perspective, Float4>(covered, 4, shading_);
        } else
            shadeAmongSurfaces<perspective, Float8>(covered, 0, shading_);
    }

    TETRA_SIMD_INLINE void addRow(const CellSetup& cell, Float8 (&now)[7], const float (&right)[7], SampleBlock* block,
                                  int count)
    {
        if (count_ > capacity - longestRow)
            shade();
        for (; count > 0; --count, ++block) {
            CoveredBlock& next = queue_[count_];
            BlockLimits* limits = nullptr;
            Float8 nearest = Float8{} + shading_.nearestBound;
            Float8 firstBack = now[3];
            if constexpr (extras == Extras::All)
                if (shading_.limits != nullptr) {
                    limits = shading_.limits + (block - blocks_);
                    nearest = limits->front;
                    firstBack = firstBack > limits->back ? firstBack : limits->back;
                }
            bool covers;
            if constexpr (lanes == 4) {
                Halves parts[6];
                for (int i = 0; i < 6; ++i)
                    parts[i] = halvesOf(i == 3 ? firstBack : now[i]);
                const Halves light = halvesOf(block->light), bounds = halvesOf(nearest);
                const BlockTest<Float4> low(parts[0].low, parts[1].low, parts[2].low, parts[3].low, parts[4].low,
                                            parts[5].low, light.low, bounds.low, cell.around);
                const BlockTest<Float4> high(parts[0].high, parts[1].high, parts[2].high, parts[3].high, parts[4].high,
                                             parts[5].high, light.high, bounds.high, cell.around);
                next.front = whole(low.front, high.front);
                next.back = whole(low.back, high.back);
                covers = any(low.covered | high.covered);
            } else {
                const BlockTest<Float8> test(now[0], now[1], now[2], firstBack, now[4], now[5], block->light, nearest,
                                             cell.around);
                next.front = test.front;
                next.back = test.back;
                covers = any(test.covered);
            }
            next.slope = now[6];
            next.block = block;
            next.cell = &cell;
            if constexpr (extras == Extras::All)
                next.meets = limits != nullptr && meetsSurface(next, limits->next) ? limits : nullptr;
            count_ += covers ? 1 : 0;
            for (int i = 0; i < 7; ++i)
                now[i] += right[i];
        }
    }

    TETRA_SIMD_INLINE static bool meetsSurface(const CoveredBlock& covered, const Float8& surface)
    {
        if constexpr (lanes == 4) {
            const Halves front = halvesOf(covered.front), back = halvesOf(covered.back), next = halvesOf(surface);
            return any(((front.low > back.low) & (next.low > back.low)) |
                       ((front.high > back.high) & (next.high > back.high)));
        } else
            return any((covered.front > covered.back) & (surface > covered.back));
    }

    const TileShading& shading_;
    SampleBlock* blocks_;
    int columns_;
    int count_ = 0;
    std::size_t shaded_ = 0;
    CoveredBlock queue_[capacity + 1];
};

template <bool perspective, Extras extras, int lanes> TETRA_SIMD_INLINE std::size_t
drawCellsBy(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
    BlockQueue<perspective, extras, lanes> queue(shading, blocks, columns);
    for (const CellSetup& cell : cells)
        if (!cell.flat)
            queue.add(cell);
    queue.shade();
    return queue.shadedBlocks();
}

} // namespace tetra
