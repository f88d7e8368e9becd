// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/model_tile.h"

#include "core/render/volume/block_queue.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace tetra {
namespace {

constexpr std::size_t lanesOfBlock = 8;

/// A block's lanes among the numbers that the model sees.
TETRA_SIMD_INLINE void storeLanes(const Float8& lanes, float* numbers)
{
    std::memcpy(numbers, &lanes, sizeof lanes);
}
TETRA_SIMD_INLINE Float8 lanesAt(const float* numbers)
{
    Float8 lanes;
    std::memcpy(&lanes, numbers, sizeof lanes);
    return lanes;
}

/// The number within [0, most]; NaN becomes 0.
TETRA_SIMD_INLINE Float8 bounded(Float8 number, Float8 most)
{
    return number > 0.0f ? smaller(number, most) : Float8{};
}

/// A block's way through a cell.
struct BlockPieces {
    Float8 front, back; ///< q of CellSetup; nothing where front <= back
    Float8 slope;
    SampleBlock* block;
    BlockTotal* total;
    const CellSetup* cell;
};

/// Pieces of rays in the order in which they are met, and what the model makes of them.
template <bool perspective> class PieceQueue {
public:
    PieceQueue(const TileShading& shading, const TileModel& model) : shading_(shading), model_(model) {}

    TETRA_SIMD_INLINE void add(const BlockPieces& next)
    {
        if (count_ == capacity)
            flush();
        const CellSetup& cell = *next.cell;
        const auto covered = next.front > next.back;
        const Float8 ones = Float8{} + 1.0f;
        const Float8 front = covered ? next.front : ones, back = covered ? next.back : ones;
        Float8 enter = -front, leave = -back, valueIn, valueOut;
        if constexpr (perspective) {
            enter = 1.0f / front;
            leave = 1.0f / back;
            valueIn = next.slope * enter + cell.constant;
            valueOut = next.slope * leave + cell.constant;
        } else {
            valueIn = next.slope + cell.constant * front;
            valueOut = next.slope + cell.constant * back;
        }
        const float origin = cell.simple ? shading_.segments[cell.firstSegment].origin : 0;
        const auto perValue = static_cast<float>(model_.perValue), smallest = static_cast<float>(model_.smallest);
        const Float8 lowest = Float8{} + cell.smallest, highest = Float8{} + cell.largest;
        const auto inData = [&](Float8 value) __attribute__((always_inline))
        {
            return smaller(larger(value + origin, lowest), highest) / perValue + smallest;
        };
        const auto unit = static_cast<float>(model_.unit);
        const std::size_t at = count_++;
        const std::size_t first = at * lanesOfBlock;
        storeLanes(inData(valueIn), entry_ + first);
        storeLanes(inData(valueOut), exit_ + first);
        storeLanes(covered ? (leave - enter) * next.block->ray * unit : Float8{}, length_ + first);
        storeLanes(Float8{} + (cell.perGradient > 0 ? 1 / (cell.perGradient * perValue * unit) : 0.0f),
                   gradient_ + first);
        enter_[at] = enter;
        leave_[at] = leave;
        pieces_[at] = next;
    }

    TETRA_SIMD_INLINE void flush()
    {
        if (count_ > 0)
            model_.optics->evaluate(
                {count_ * lanesOfBlock, entry_, exit_, length_, gradient_, red_, green_, blue_, transmittance_});
        for (std::size_t at = 0; at < count_; ++at)
            combine(at);
        shaded_ += count_;
        count_ = 0;
    }

    std::size_t shadedBlocks() const { return shaded_; }

private:
    static constexpr std::size_t capacity = 32;
    static constexpr std::size_t numbers = capacity * lanesOfBlock;

    TETRA_SIMD_INLINE void combine(std::size_t at)
    {
        const BlockPieces& pieces = pieces_[at];
        const Float8 ones = Float8{} + 1.0f;
        const auto covered = pieces.front > pieces.back;
        const std::size_t first = at * lanesOfBlock;
        const Float8 opacity = covered ? bounded(ones - lanesAt(transmittance_ + first), ones) : Float8{};
        const Float8 red = bounded(lanesAt(red_ + first), opacity);
        const Float8 green = bounded(lanesAt(green_ + first), opacity);
        const Float8 blue = bounded(lanesAt(blue_ + first), opacity);
        if (model_.optics->combiner == Combiner::Over) {
            SampleBlock& block = *pieces.block;
            const Float8 before = block.transmittance > opaqueThreshold ? block.transmittance : Float8{};
            block.red += before * red;
            block.green += before * green;
            block.blue += before * blue;
            const Float8 left = block.transmittance - before * opacity;
            if (shading_.depth)
                keepDepth(block, 0, left, enter_[at], leave_[at]);
            block.transmittance = left;
            return;
        }
        BlockTotal& total = *pieces.total;
        const bool adds = model_.optics->combiner == Combiner::Sum;
        total.red = adds ? total.red + red : larger(total.red, red);
        total.green = adds ? total.green + green : larger(total.green, green);
        total.blue = adds ? total.blue + blue : larger(total.blue, blue);
        total.opacity = adds ? total.opacity + opacity : larger(total.opacity, opacity);
    }

    const TileShading& shading_;
    const TileModel& model_;
    std::size_t count_ = 0;
    std::size_t shaded_ = 0;
    alignas(64) float entry_[numbers], exit_[numbers], length_[numbers], gradient_[numbers];
    alignas(64) float red_[numbers], green_[numbers], blue_[numbers], transmittance_[numbers];
    std::array<Float8, capacity> enter_, leave_; ///< w
    std::array<BlockPieces, capacity> pieces_;
};

/// A block whose rays meet surfaces in a cell or before it: each surface ends one piece and begins the next (R21), as
/// in shadeAmongSurfaces().
template <bool perspective> TETRA_SIMD_INLINE void drawAmongSurfaces(PieceQueue<perspective>& queue,
                                                                     const BlockPieces& whole, BlockLimits& limits,
                                                                     const TileShading& shading)
{
    BlockPieces part = whole;
    queue.flush(); // whether a surface is seen depends on the light that is left
    bool more = true;
    while (more) {
        const auto meets =
            (whole.front > whole.back) & (limits.next > whole.back) & (whole.block->transmittance > opaqueThreshold);
        part.back = meets ? (shading.splitCells ? smaller(limits.next, part.front) : part.front) : whole.back;
        queue.add(part);
        queue.flush();
        part.front = part.back;
        more = any(meets);
        for (std::size_t lane = 0; more && lane < lanesOfBlock; ++lane)
            if (meets[lane])
                drawSurface(shading.fragments, perspective, lane, *whole.block, limits);
    }
}

template <bool perspective> TETRA_SIMD_INLINE std::size_t drawBy(std::span<const CellSetup> cells,
                                                                 const TileShading& shading, SampleBlock* blocks,
                                                                 BlockTotal* totals, int columns)
{
    PieceQueue<perspective> queue(shading, *shading.model);
    const bool isOver = shading.model->optics->combiner == Combiner::Over;
    for (const CellSetup& cell : cells) {
        if (cell.flat)
            continue;
        for (int row = cell.top; row < cell.bottom; ++row)
            for (int column = cell.left; column < cell.right; ++column) {
                const auto x = static_cast<float>(column * blockWidth), y = static_cast<float>(row * blockHeight);
                Float8 at[7];
                for (int i = 0; i < 7; ++i)
                    at[i] = atLanes(cell.functions[i], x, y);
                const int number = row * columns + column;
                SampleBlock* block = blocks + number;
                BlockLimits* limits = shading.limits != nullptr ? shading.limits + number : nullptr;
                Float8 nearest = Float8{} + shading.nearestBound;
                if (limits != nullptr) {
                    nearest = limits->front;
                    at[3] = larger(at[3], limits->back);
                }
                const BlockTest<Float8> test(at[0], at[1], at[2], at[3], at[4], at[5], block->transmittance, nearest,
                                             cell.around);
                if (!any(test.covered))
                    continue;
                const BlockPieces pieces{test.front, test.back, at[6], block, totals + number, &cell};
                if (isOver && limits != nullptr && any((test.front > test.back) & (limits->next > test.back)))
                    drawAmongSurfaces<perspective>(queue, pieces, *limits, shading);
                else
                    queue.add(pieces);
            }
    }
    queue.flush();
    return queue.shadedBlocks();
}

} // namespace

std::size_t drawCellsByModel(std::span<const CellSetup> cells, const TileShading& shading, SampleBlock* blocks,
                             BlockTotal* totals, int columns)
{
    return shading.perspective ? drawBy<true>(cells, shading, blocks, totals, columns)
                               : drawBy<false>(cells, shading, blocks, totals, columns);
}

} // namespace tetra
