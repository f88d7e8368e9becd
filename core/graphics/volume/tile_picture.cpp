// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/tile_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {
namespace {

constexpr int columns = volumeTileSide / blockWidth;
constexpr int rows = volumeTileSide / blockHeight;
/// Cells between two looks whether all is opaque, and whether to stop.
constexpr std::size_t batch = 64;

/// Where a sample of a tile is kept.
struct BlockLane {
    std::size_t block;
    std::size_t lane;

    BlockLane(int x, int y)
        : block(static_cast<std::size_t>(y / blockHeight * columns + x / blockWidth)),
          lane(static_cast<std::size_t>(y % blockHeight * blockWidth + x % blockWidth))
    {
    }
};

} // namespace

VolumeTilePainter::VolumeTilePainter(const SetupSource& source, const VolumeView& view)
    : source_(source), view_(view), blocks_(static_cast<std::size_t>(columns * rows)), setups_(batch)
{
}

void VolumeTilePainter::clear(const SampleRectangle& tile)
{
    firstLit_ = 0;
    std::ranges::fill(blocks_, SampleBlock{{}, {}, {}, {}, {}, Float8{} + noDepth});
    for (int y = 0; y < tile.height(); ++y)
        for (int x = 0; x < tile.width(); ++x) {
            const BlockLane place(x, y);
            const double slopeX = (tile.left + x + view_.firstX()) / view_.samplesPerSlope.x();
            const double slopeY = (tile.top + y + view_.firstY()) / view_.samplesPerSlope.y();
            blocks_[place.block].light[place.lane] = 1;
            blocks_[place.block].ray[place.lane] =
                view_.perspective ? static_cast<float>(std::sqrt(1 + slopeX * slopeX + slopeY * slopeY)) : 1;
        }
}

bool VolumeTilePainter::allDark()
{
    const auto lit = [](const SampleBlock& block) {
        for (std::size_t lane = 0; lane < 8; ++lane)
            if (block.light[lane] > darkness)
                return true;
        return false;
    };
    // What is dark stays dark.
    while (firstLit_ < blocks_.size() && !lit(blocks_[firstLit_]))
        ++firstLit_;
    return firstLit_ == blocks_.size();
}

void VolumeTilePainter::write(const SampleRectangle& tile, VolumePicture& picture) const
{
    for (int y = 0; y < tile.height(); ++y)
        for (int x = 0; x < tile.width(); ++x) {
            const BlockLane place(x, y);
            const SampleBlock& block = blocks_[place.block];
            const auto sample = static_cast<std::size_t>(tile.top + y) * static_cast<std::size_t>(picture.width) +
                                static_cast<std::size_t>(tile.left + x);
            picture.samples[sample] = {block.red[place.lane], block.green[place.lane], block.blue[place.lane],
                                       1 - block.light[place.lane]};
            if (!picture.depth.empty())
                picture.depth[sample] = block.depth[place.lane] < noDepth
                                            ? static_cast<float>(block.depth[place.lane] * view_.unit)
                                            : std::numeric_limits<float>::infinity();
        }
}

std::size_t VolumeTilePainter::paint(const SampleRectangle& tile, std::span<const BinnedCell> cells,
                                     const Progress& progress, VolumePicture& picture)
{
    clear(tile);
    const auto largest = [](double first, int count) { return std::max(std::abs(first), std::abs(first + count - 1)); };
    const double slopeX = largest(tile.left + view_.firstX(), tile.width()) / view_.samplesPerSlope.x();
    const double slopeY = largest(tile.top + view_.firstY(), tile.height()) / view_.samplesPerSlope.y();
    const TileFrame frame{static_cast<float>(tile.left + view_.firstX()), static_cast<float>(tile.top + view_.firstY()),
                          view_.perspective ? static_cast<float>(std::sqrt(1 + slopeX * slopeX + slopeY * slopeY)) : 1};
    const TileShading shading{source_.segments.data(),
                              view_.perspective ? static_cast<float>(1 / view_.nearest) : farBound, view_.perspective,
                              !picture.depth.empty()};
    std::size_t drawn = 0;
    while (drawn < cells.size() && !progress.cancelled()) {
        const auto next = cells.subspan(drawn, std::min(batch, cells.size() - drawn));
        setUpCells(source_, frame, next, setups_);
        drawCells(std::span(setups_).first(next.size()), shading, blocks_.data(), columns);
        drawn += next.size();
        if (allDark())
            break;
    }
    write(tile, picture);
    return drawn;
}

} // namespace tetra
