// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"
#include "core/render/volume/block_shading.h"
#include "core/render/volume/cell_setup.h"

#include <algorithm>

namespace tetra {

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

static_assert(blockWidth == 4 && blockHeight == 2, "lanes are named by their place in the block");
TETRA_SIMD_INLINE Float8 atLanes(const AffineFunction& function, float x, float y)
{
    return function.a * (laneX + x) + (function.b * (laneY + y) + function.c);
}

/// Where the rays of a block are inside a cell.
template <class Lanes> struct BlockTest {
    Lanes front, back;
    decltype(Lanes{} > Lanes{}) covered; ///< and light still comes through

    TETRA_SIMD_INLINE BlockTest(Lanes front0, Lanes front1, Lanes front2, Lanes back0, Lanes back1, Lanes back2,
                                Lanes transmittance, Lanes nearest, bool around)
        : front(smaller(smaller(front0, front1), smaller(front2, nearest))), back(larger(larger(back0, back1), back2))
    {
        if (around) [[unlikely]] {
            front = nearest;
            back = larger(back, front0);
        }
        covered = (front > back) & (transmittance > opaqueThreshold);
    }
};

/// Blocks are first found and then shaded, many at a time: whether a block is covered is hard to predict, and a wrong
/// guess costs as much as half the shading.
/// `lanes`: how many rays the machine does at a time, 4, 8 or 16.
template <bool perspective, KernelFeatures extras, int lanes> class BlockQueue {
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
            addRow(cell, now, right, left, row, end - left);
            for (int i = 0; i < 7; ++i)
                rows[i] += down[i];
        }
    }

    TETRA_SIMD_INLINE void shade()
    {
        int i = 0;
        while (i < count_) {
            const CoveredBlock* next = queue_ + i;
            if constexpr (hasLimits(extras))
                if (next->meets != nullptr) {
                    shadeWithSurfaces(*next);
                    ++i;
                    continue;
                }
            if constexpr (lanes == 16)
                if (i + 1 < count_ && next[0].cell == next[1].cell &&
                    (!hasLimits(extras) || next[1].meets == nullptr)) {
                    shadeTwo<perspective, extras>(next[0], next[1], shading_);
                    i += 2;
                    continue;
                }
            if constexpr (lanes == 4)
                shadeHalves<perspective, extras>(*next, shading_);
            else
                shadeOne<perspective, extras>(*next, shading_);
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
            shadeAmongSurfaces<perspective, extras, Float4>(covered, 0, shading_);
            shadeAmongSurfaces<perspective, extras, Float4>(covered, 4, shading_);
        } else
            shadeAmongSurfaces<perspective, extras, Float8>(covered, 0, shading_);
    }

    TETRA_SIMD_INLINE void addRow(const CellSetup& cell, Float8 (&now)[7], const float (&right)[7], int column, int row,
                                  int count)
    {
        SampleBlock* block = blocks_ + std::ptrdiff_t(row) * columns_ + column;
        [[maybe_unused]] float x = static_cast<float>(column * blockWidth);
        [[maybe_unused]] const float y = static_cast<float>(row * blockHeight);
        if (count_ > capacity - longestRow)
            shade();
        for (; count > 0; --count, ++block) {
            CoveredBlock& next = queue_[count_];
            BlockLimits* limits = nullptr;
            Float8 nearest = Float8{} + shading_.nearestBound;
            Float8 firstBack = now[3];
            if constexpr (hasLimits(extras))
                if (shading_.limits != nullptr) {
                    limits = shading_.limits + (block - blocks_);
                    nearest = limits->front;
                    firstBack = firstBack > limits->back ? firstBack : limits->back;
                }
            bool covers = false;
            if constexpr (lanes == 4) {
                Halves parts[6];
                for (int i = 0; i < 6; ++i)
                    parts[i] = halvesOf(i == 3 ? firstBack : now[i]);
                const Halves transmittance = halvesOf(block->transmittance), bounds = halvesOf(nearest);
                const BlockTest<Float4> low(parts[0].low, parts[1].low, parts[2].low, parts[3].low, parts[4].low,
                                            parts[5].low, transmittance.low, bounds.low, cell.around);
                const BlockTest<Float4> high(parts[0].high, parts[1].high, parts[2].high, parts[3].high, parts[4].high,
                                             parts[5].high, transmittance.high, bounds.high, cell.around);
                next.front = whole(low.front, high.front);
                next.back = whole(low.back, high.back);
                covers = any(low.covered | high.covered);
            } else {
                const BlockTest<Float8> test(now[0], now[1], now[2], firstBack, now[4], now[5], block->transmittance,
                                             nearest, cell.around);
                next.front = test.front;
                next.back = test.back;
                covers = any(test.covered);
            }
            next.slope = now[6];
            next.block = block;
            next.cell = &cell;
            if constexpr (hasLimits(extras))
                next.meets = limits != nullptr && meetsSurface(next, limits->next) ? limits : nullptr;
            if constexpr (extras == KernelFeatures::Lit) {
                next.x = x;
                next.y = y;
                x += blockWidth;
            }
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

template <bool perspective, KernelFeatures extras, int lanes> TETRA_SIMD_INLINE std::size_t
drawCellsBy(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks, int columns)
{
    BlockQueue<perspective, extras, lanes> queue(shading, blocks, columns);
    for (const CellSetup& cell : cells)
        if (!cell.flat)
            queue.add(cell);
    queue.shade();
    return queue.shadedBlocks();
}

/// By as many rays at a time as the machine can do. Each kernel is a function of its own: compilers take long over
/// large ones.
template <bool perspective, KernelFeatures extras> inline constexpr auto drawAtOnce =
    dispatch<drawCellsBy<perspective, extras, 4>, drawCellsBy<perspective, extras, 8>,
             drawCellsBy<perspective, extras, 16>>;

template <KernelFeatures extras> std::size_t drawCellsWith(std::span<const CellSetup> cells, const TileShading& shading,
                                                           SampleBlock* blocks, int columns)
{
    return shading.perspective ? drawAtOnce<true, extras>(cells, shading, blocks, columns)
                               : drawAtOnce<false, extras>(cells, shading, blocks, columns);
}

/// In sources of their own, as they take long to compile.
std::size_t drawCellsWithExtras(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks,
                                int columns);
std::size_t drawLitCells(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks,
                         int columns);

} // namespace tetra
