// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/tile_picture.h"

#include "core/graphics/volume/block_lane.h"
#include "core/graphics/volume/sample_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {
namespace {

constexpr int columns = volumeTileSide / blockWidth;
constexpr int rows = volumeTileSide / blockHeight;
/// Cells between two looks whether all is opaque, and whether to stop.
constexpr std::size_t cellsInBatch = 64;

/// Calls visit(sample, block, lane) for the samples of a tile, row by row.
template <class Visit> void forEachTileSample(const SampleRectangle& tile, Visit&& visit)
{
    std::size_t sample = 0;
    for (int y = 0; y < tile.height(); ++y)
        for (int x = 0; x < tile.width(); ++x, ++sample) {
            const auto [block, lane] = BlockLane(x, y);
            visit(sample, block, lane);
        }
}

bool isLimited(const TileSurroundings& surroundings)
{
    return surroundings.clips != nullptr || surroundings.surfaces != nullptr || surroundings.focus != nullptr;
}

} // namespace

VolumeTilePainter::VolumeTilePainter(const SetupSource& source, const VolumeView& view)
    : source_(source), view_(view), blocks_(static_cast<std::size_t>(columns * rows)), setups_(cellsInBatch)
{
}

void VolumeTilePainter::clear(const SampleRectangle& tile)
{
    firstLit_ = 0;
    clearBlocks(view_, tile, blocks_);
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

void VolumeTilePainter::setLimits(const SampleRectangle& tile, const TileSurroundings& surroundings)
{
    const float nearest = view_.perspective ? static_cast<float>(1 / view_.nearest) : farBound;
    limits_.assign(blocks_.size(), {Float8{} + nearest, Float8{} - farBound, Float8{} - farBound, {}});
    std::size_t sample = 0;
    for (int y = 0; y < tile.height(); ++y)
        for (int x = 0; x < tile.width(); ++x, ++sample) {
            const BlockLane place(x, y);
            BlockLimits& limits = limits_[place.block];
            if (surroundings.clips != nullptr) {
                const ClipBounds::Interval shown = surroundings.clips->at(tile.left + x, tile.top + y);
                limits.front[place.lane] = std::min(nearest, shown.front);
                limits.back[place.lane] = shown.back;
            }
            if (surroundings.surfaces != nullptr) {
                limits.place[place.lane] = surroundings.surfaces->first[sample];
                limits.next[place.lane] = surroundings.surfaces->fragments[limits.place[place.lane]].nearness;
            }
        }
}

TileShading VolumeTilePainter::shadingOf(const TileSurroundings& surroundings)
{
    const bool limited = isLimited(surroundings);
    TileShading shading;
    shading.segments = source_.segments.data();
    shading.nearestBound = view_.perspective ? static_cast<float>(1 / view_.nearest) : farBound;
    shading.perspective = view_.perspective;
    shading.depth = surroundings.depth;
    shading.extras = limited || source_.shaded;
    shading.limits = limited ? limits_.data() : nullptr;
    shading.fragments = surroundings.surfaces != nullptr ? surroundings.surfaces->fragments.data() : nullptr;
    shading.splitCells = surroundings.splitCells;
    return shading;
}

TileFrame VolumeTilePainter::frameOf(const SampleRectangle& tile) const
{
    const auto largest = [](double first, int count) { return std::max(std::abs(first), std::abs(first + count - 1)); };
    const double slopeX = largest(tile.left + view_.firstX(), tile.width()) / view_.samplesPerSlope.x();
    const double slopeY = largest(tile.top + view_.firstY(), tile.height()) / view_.samplesPerSlope.y();
    return {static_cast<float>(tile.left + view_.firstX()), static_cast<float>(tile.top + view_.firstY()),
            view_.perspective ? static_cast<float>(std::sqrt(1 + slopeX * slopeX + slopeY * slopeY)) : 1};
}

void VolumeTilePainter::finish(const SampleRectangle& tile, const TileShading& shading)
{
    const auto samples = static_cast<std::size_t>(tile.width()) * static_cast<std::size_t>(tile.height());
    colours_.resize(samples);
    depth_.resize(shading.depth ? samples : 0);
    if (shading.fragments != nullptr)
        forEachTileSample(tile, [&](std::size_t, std::size_t block, std::size_t lane) {
            drawSurfacesBehind(shading, lane, blocks_[block], limits_[block]);
        });
    takeColours(blocks_, tile, colours_);
    if (shading.depth)
        forEachTileSample(tile, [&](std::size_t sample, std::size_t block, std::size_t lane) {
            const float depth = blocks_[block].depth[lane];
            depth_[sample] =
                depth < noDepth ? static_cast<float>(depth * view_.unit) : std::numeric_limits<float>::infinity();
        });
}

void VolumeTilePainter::draw(const SetupSource& source, std::span<const BinnedCell> cells, const SampleRectangle& tile,
                             const TileShading& shading, const Progress& progress, DrawnTile& drawn)
{
    const TileFrame frame = frameOf(tile);
    const auto batchFrom = [cells](std::size_t first) {
        const std::size_t begin = std::min(first, cells.size());
        return cells.subspan(begin, std::min(cellsInBatch, cells.size() - begin));
    };
    fetchCells(source, batchFrom(0));
    fetchCells(source, batchFrom(cellsInBatch));
    for (std::size_t first = 0; first < cells.size() && !progress.cancelled(); first += cellsInBatch) {
        const auto now = batchFrom(first);
        setUpCells(source, frame, now, setups_);
        // What comes next is asked for before a long time of drawing.
        fetchCorners(source, batchFrom(first + cellsInBatch));
        fetchCells(source, batchFrom(first + 2 * cellsInBatch));
        drawn.fragments += drawCells(std::span(setups_).first(now.size()), shading, blocks_.data(), columns);
        drawn.cells += now.size();
        if (allDark())
            break;
    }
}

DrawnTile VolumeTilePainter::paint(const SampleRectangle& tile, std::span<const BinnedCell> cells,
                                   const TileSurroundings& surroundings, const Progress& progress)
{
    clear(tile);
    if (isLimited(surroundings))
        setLimits(tile, surroundings);
    DrawnTile drawn;
    if (surroundings.focus != nullptr && setPassages(tile, *surroundings.focus->rays))
        drawWithFocus(tile, cells, surroundings, progress, drawn);
    else {
        const TileShading shading = shadingOf(surroundings);
        draw(source_, cells, tile, shading, progress, drawn);
        finish(tile, shading);
    }
    drawn.fragments *= blockWidth * blockHeight;
    drawn.colours = colours_;
    drawn.depth = depth_;
    return drawn;
}

} // namespace tetra
