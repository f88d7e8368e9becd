// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/border_fragments.h"

#include "core/graphics/volume/block_queue.h"

namespace tetra {
namespace {

/// The border is cut into this many layers along a ray on either side of the region.
constexpr int layers = 4;

/// The rays of a block in a cell; w.
struct CellPassage {
    Float8 enter, leave, slope;
};

TETRA_SIMD_INLINE CellPassage passageOf(const CellSetup& cell, float x, float y, bool perspective)
{
    Float8 at[7];
    for (int i = 0; i < 7; ++i)
        at[i] = atLanes(cell.functions[i], x, y);
    Float8 front = smaller(smaller(at[0], at[1]), at[2]);
    Float8 back = larger(larger(at[3], at[4]), at[5]);
    if (cell.around) {
        front = Float8{} + farBound;
        back = larger(back, at[0]);
    }
    if (!perspective)
        return {-front, -back, at[6]};
    // A face whose plane a ray leaves by behind the eye does not bind before it.
    const Float8 never = Float8{} + farBound;
    return {front > 0.0f ? 1.0f / front : never, back > 0.0f ? 1.0f / back : never, at[6]};
}

/// Shades the rays of a block from `from` to `to`, and adds what they gather.
template <bool perspective> TETRA_SIMD_INLINE void collectLayer(const CellSetup& cell, bool fine,
                                                                const BorderTile& tile, int column, int row,
                                                                const CellPassage& passage, Float8 from, Float8 to,
                                                                std::vector<BorderFragment>& fragments)
{
    from = larger(from, passage.enter);
    to = smaller(to, passage.leave);
    if (!anyPositive(to - from))
        return;
    const SampleBlock& block = tile.blocks[static_cast<std::size_t>(row * tile.columns + column)];
    Float8 weight = {}, front = Float8{} + 1.0f, back = front;
    for (int lane = 0; lane < 8; ++lane)
        if (to[lane] > from[lane]) {
            const int x = tile.tile.left + column * blockWidth + lane % blockWidth;
            const int y = tile.tile.top + row * blockHeight + lane / blockWidth;
            const double ofFine = tile.rays->weightAt(x, y, 0.5 * (double(from[lane]) + to[lane]));
            weight[lane] = static_cast<float>(fine ? ofFine : 1 - ofFine);
            front[lane] = perspective ? 1 / from[lane] : -from[lane];
            back[lane] = perspective ? 1 / to[lane] : -to[lane];
        }
    // A part of the optical depth is that of a part of the way.
    CellRays<Float8> rays = {front, back, passage.slope, block.ray * weight, {}, {}};
    const Gathered<Float8> nothing = {{}, {}, {}, Float8{} + 1.0f};
    Gathered<Float8> gathered = nothing;
    shade<perspective>(rays, cell, tile.segments, gathered);
    rays.ray = block.ray;
    if (cell.perGradient > 0)
        relight<perspective>(gathered, nothing, rays, cell);
    for (int lane = 0; lane < 8; ++lane)
        if (to[lane] > from[lane] && gathered.light[lane] < 1) {
            const int x = column * blockWidth + lane % blockWidth, y = row * blockHeight + lane / blockWidth;
            const float middle = (from[lane] + to[lane]) / 2;
            fragments.push_back(
                {static_cast<std::uint32_t>(y * tile.tile.width() + x),
                 {perspective ? 1 / middle : -middle,
                  {gathered.red[lane], gathered.green[lane], gathered.blue[lane], 1 - gathered.light[lane]}}});
        }
}

template <bool perspective> TETRA_SIMD_INLINE void collectBlock(const CellSetup& cell, bool fine,
                                                                const BorderTile& tile, int column, int row,
                                                                std::vector<BorderFragment>& fragments)
{
    const BlockPassage& region = tile.passages[static_cast<std::size_t>(row * tile.columns + column)];
    if (!anyPositive(region.leave - region.enter))
        return;
    const CellPassage passage =
        passageOf(cell, static_cast<float>(column * blockWidth), static_cast<float>(row * blockHeight), perspective);
    const Float8 ends[2][2] = {{region.enter, region.in}, {region.out, region.leave}};
    for (const auto& [first, last] : ends) {
        const Float8 step = (last - first) * (1.0f / layers);
        for (int layer = 0; layer < layers; ++layer) {
            const auto number = static_cast<float>(layer);
            collectLayer<perspective>(cell, fine, tile, column, row, passage, first + number * step,
                                      first + (number + 1) * step, fragments);
        }
    }
}

} // namespace

TETRA_SIMD_CLONES void collectBorder(std::span<const CellSetup> cells, bool fine, const BorderTile& tile,
                                     std::vector<BorderFragment>& fragments)
{
    for (const CellSetup& cell : cells) {
        if (cell.flat)
            continue;
        for (int row = cell.top; row < cell.bottom; ++row)
            for (int column = cell.left; column < cell.right; ++column)
                if (tile.perspective)
                    collectBlock<true>(cell, fine, tile, column, row, fragments);
                else
                    collectBlock<false>(cell, fine, tile, column, row, fragments);
    }
}

} // namespace tetra
