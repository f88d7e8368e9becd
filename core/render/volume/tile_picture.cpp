// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/tile_picture.h"

#include "core/render/volume/sample_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

// The part of VolumeTilePainter that draws a finer volume inside a region (R24).

namespace tetra {

namespace {

/// Where a sample of a tile is kept: in which of its blocks, and in which lane of that.
struct BlockLane {
    std::size_t block;
    std::size_t lane;

    BlockLane(int x, int y)
        : block(static_cast<std::size_t>(y / blockHeight * (volumeTileSide / blockWidth) + x / blockWidth)),
          lane(static_cast<std::size_t>(y % blockHeight * blockWidth + x % blockWidth))
    {
    }
};

/// What follows from where the cells come from.
void useSource(TileShading& shading, const SetupSource& source)
{
    shading.segments = source.segments.data();
    shading.lit = !source.gradients.empty();
    shading.perFullGradient = source.perFullGradient;
}

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
    : source_(source), view_(view), blocks_(static_cast<std::size_t>(columns * rows)), setups_(cellsInBatch),
      lights_(cellsInBatch)
{
}

void VolumeTilePainter::clear(const SampleRectangle& tile)
{
    firstLit_ = 0;
    clearBlocks(view_, tile, blocks_);
}

bool VolumeTilePainter::allOpaque()
{
    const auto lit = [](const SampleBlock& block) {
        for (std::size_t lane = 0; lane < 8; ++lane)
            if (block.transmittance[lane] > opaqueThreshold)
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

TileShading VolumeTilePainter::shadingOf(const SampleRectangle& tile, const TileSurroundings& surroundings)
{
    const bool limited = isLimited(surroundings);
    TileShading shading;
    useSource(shading, source_);
    shading.nearestBound = view_.perspective ? static_cast<float>(1 / view_.nearest) : farBound;
    shading.perspective = view_.perspective;
    shading.depth = surroundings.depth;
    shading.extras = limited;
    shading.firstX = static_cast<float>(tile.left + view_.firstX());
    shading.firstY = static_cast<float>(tile.top + view_.firstY());
    if (view_.perspective) {
        shading.slopePerSample[0] = static_cast<float>(1 / view_.samplesPerSlope.x());
        shading.slopePerSample[1] = static_cast<float>(1 / view_.samplesPerSlope.y());
    }
    shading.limits = limited ? limits_.data() : nullptr;
    shading.fragments = surroundings.surfaces != nullptr ? surroundings.surfaces->fragments.data() : nullptr;
    shading.splitCells = surroundings.splitCells;
    shading.model = surroundings.model;
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
        setUpCells(source, frame, now, setups_, lights_);
        // What comes next is asked for before a long time of drawing.
        fetchCorners(source, batchFrom(first + cellsInBatch));
        fetchCells(source, batchFrom(first + 2 * cellsInBatch));
        const auto cellsNow = std::span<const CellSetup>(setups_).first(now.size());
        drawn.fragments += shading.model != nullptr
                               ? drawCellsByModel(cellsNow, shading, blocks_.data(), totals_.data(), columns)
                               : drawCells(cellsNow, shading, blocks_.data(), columns);
        drawn.cells += now.size();
        if (allOpaque())
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
    totals_.resize(surroundings.model != nullptr ? blocks_.size() : 0);
    if (surroundings.model != nullptr && surroundings.model->optics->combiner != Combiner::Over)
        drawTotals(tile, cells, surroundings, progress, drawn);
    else if (surroundings.focus != nullptr && setIntervals(tile, *surroundings.focus->rays))
        drawWithFocus(tile, cells, surroundings, progress, drawn);
    else {
        const TileShading shading = shadingOf(tile, surroundings);
        draw(source_, cells, tile, shading, progress, drawn);
        finish(tile, shading);
    }
    drawn.fragments *= std::size_t{blockWidth} * blockHeight;
    drawn.colours = colours_;
    drawn.depth = depth_;
    return drawn;
}

DrawnTile VolumeTilePainter::paintBlocks(const SampleRectangle& tile, const TileSurroundings& surroundings,
                                         const BlockDrawing& draw)
{
    clear(tile);
    if (isLimited(surroundings))
        setLimits(tile, surroundings);
    const TileShading shading = shadingOf(tile, surroundings);
    draw(shading, blocks_.data(), columns, rows);
    finish(tile, shading);
    return {.colours = colours_, .depth = depth_};
}

/// Rays end at the first surface that lets nothing through; no surface meets a cell.
void VolumeTilePainter::endAtOpaque(const SurfaceFragments& surfaces)
{
    for (BlockLimits& limits : limits_)
        for (std::size_t lane = 0; lane < 8; ++lane) {
            if (limits.next[lane] <= -farBound)
                continue;
            for (std::uint32_t i = limits.place[lane]; surfaces.fragments[i].nearness > -farBound; ++i)
                if (surfaces.fragments[i].colour[3] >= 1) {
                    limits.back[lane] = std::max(limits.back[lane], surfaces.fragments[i].nearness);
                    break;
                }
            limits.next[lane] = -farBound;
        }
}

namespace {

/// What is seen of a ray that has gathered this much in a lane.
PremultipliedColour seenOf(const OpticalModel& optics, const BlockTotal& total, std::size_t lane)
{
    const float opacity = std::min(total.opacity[lane], 1.0f);
    if (!optics.lightOfRay)
        return {std::min(total.red[lane], 1.0f), std::min(total.green[lane], 1.0f), std::min(total.blue[lane], 1.0f),
                opacity};
    PremultipliedColour seen = opacity > 0 ? optics.lightOfRay(opacity) : PremultipliedColour{};
    const auto bounded = [](float number, float most) { return number > 0 ? std::min(number, most) : 0; };
    seen[3] = bounded(seen[3], 1);
    for (std::size_t channel = 0; channel < 3; ++channel)
        seen[channel] = bounded(seen[channel], seen[3]);
    return seen;
}

} // namespace

/// What the rays have gathered becomes the light of the blocks, before that of the surfaces. Depth is that of the
/// surfaces alone.
void VolumeTilePainter::takeTotals(const TileShading& shading)
{
    const auto drawSurfaces = [&](std::size_t number, SampleBlock& block) {
        if (shading.fragments == nullptr)
            return;
        BlockLimits limits = limits_[number];
        for (std::size_t lane = 0; lane < 8; ++lane)
            drawSurfacesBehind(shading, lane, block, limits);
    };
    for (std::size_t number = 0; number < blocks_.size(); ++number) {
        SampleBlock& block = blocks_[number];
        const BlockTotal& total = totals_[number];
        SampleBlock alone = block;
        drawSurfaces(number, alone);
        for (std::size_t lane = 0; lane < 8; ++lane) {
            const auto [red, green, blue, opacity] = seenOf(*shading.model->optics, total, lane);
            block.red[lane] = red;
            block.green[lane] = green;
            block.blue[lane] = blue;
            block.transmittance[lane] *= 1 - opacity;
        }
        drawSurfaces(number, block);
        block.depth = alone.depth;
    }
}

/// A model whose pieces are not put over each other: the volume as a whole lies before the translucent surfaces.
void VolumeTilePainter::drawTotals(const SampleRectangle& tile, std::span<const BinnedCell> cells,
                                   const TileSurroundings& surroundings, const Progress& progress, DrawnTile& drawn)
{
    totals_.assign(blocks_.size(), BlockTotal{{}, {}, {}, {}});
    TileShading shading = shadingOf(tile, surroundings);
    const std::vector<BlockLimits> whole = limits_;
    if (surroundings.surfaces != nullptr)
        endAtOpaque(*surroundings.surfaces);
    draw(source_, cells, tile, shading, progress, drawn);
    limits_ = whole;
    takeTotals(shading);
    shading.fragments = nullptr;
    finish(tile, shading);
}

namespace {

/// Cells set up at a time.
constexpr std::size_t borderBatch = 64;

/// The q (CellSetup) of a place w along a ray.
float focusNearness(double w, bool perspective)
{
    if (!perspective)
        return static_cast<float>(-w);
    return w > 0 ? static_cast<float>(std::min<double>(1 / w, farBound)) : farBound;
}

} // namespace

/// False if no ray of the tile meets the focus. What clip planes hide is left out of the intervals.
bool VolumeTilePainter::setIntervals(const SampleRectangle& tile, const FocusRays& rays)
{
    intervals_.clear();
    std::vector<FocusRays::RayInterval> ofRay;
    for (int y = 0; y < tile.height(); ++y)
        for (int x = 0; x < tile.width(); ++x) {
            rays.intervalsAt(tile.left + x, tile.top + y, ofRay);
            const auto [number, lane] = BlockLane(x, y);
            const double front = limits_[number].front[lane], back = limits_[number].back[lane];
            const bool perspective = view_.perspective;
            const double nearest = perspective ? 1 / std::max<double>(front, 1e-30) : -front;
            const double farthest = !perspective ? -back : back > 0 ? 1 / back : double(farBound);
            const auto shown = [&](double w) {
                return static_cast<float>(std::max(nearest, std::min(w, std::max(nearest, farthest))));
            };
            std::size_t place = 0;
            for (const auto& [enter, in, out, leave] : ofRay) {
                if (!(shown(enter) < shown(leave)))
                    continue;
                if (place == intervals_.size())
                    intervals_.emplace_back(blocks_.size(), BlockInterval{{}, {}, {}, {}});
                BlockInterval& interval = intervals_[place++][number];
                interval.enter[lane] = shown(enter);
                interval.in[lane] = shown(in);
                interval.out[lane] = shown(out);
                interval.leave[lane] = shown(leave);
            }
        }
    return !intervals_.empty();
}

void VolumeTilePainter::collectBorderOf(const SampleRectangle& tile, std::span<const BinnedCell> cells,
                                        const FocusTile& focus, bool fine, const Progress& progress)
{
    const SetupSource& source = fine ? *focus.source : source_;
    const auto positions = fine ? focus.finePositions : focus.positions;
    const std::vector<FocusWeights> weights = focus.rays->weightsFrom(tile.left, tile.top);
    const TileFrame frame = frameOf(tile);
    TileShading shading = shadingOf(tile, {});
    useSource(shading, source);
    std::vector<BinnedCell> outside;
    for (std::size_t first = 0; first < cells.size() && !progress.cancelled(); first += borderBatch) {
        outside.clear();
        for (const BinnedCell& cell : cells.subspan(first, std::min(borderBatch, cells.size() - first)))
            if (!focus.rays->holds(source.tetrahedra[cell.cell], positions))
                outside.push_back(cell);
        setUpCells(source, frame, outside, setups_, lights_);
        for (const auto& intervals : intervals_)
            collectBorder(std::span(setups_).first(outside.size()), fine,
                          {weights, tile, intervals, blocks_, volumeTileSide / blockWidth, shading}, border_);
    }
}

/// Both kinds of fragments of each sample in one list, front to back.
void VolumeTilePainter::putBorderAmong(const SampleRectangle& tile, const SurfaceFragments* surfaces)
{
    const auto samples = static_cast<std::uint32_t>(tile.width() * tile.height());
    if (surfaces != nullptr)
        for (std::uint32_t sample = 0; sample < samples; ++sample)
            for (std::uint32_t i = surfaces->first[sample]; surfaces->fragments[i].nearness > -farBound; ++i)
                border_.push_back({sample, surfaces->fragments[i]});
    std::vector<std::uint32_t>& first = amongBorder_.first;
    first.assign(samples + 1, 0);
    for (const BorderFragment& fragment : border_)
        ++first[fragment.sample + 1];
    for (std::uint32_t sample = 0; sample < samples; ++sample)
        first[sample + 1] += first[sample] + 1; // one more for the end
    amongBorder_.fragments.assign(first.back(), {-farBound, {}});
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (const BorderFragment& fragment : border_)
        amongBorder_.fragments[next[fragment.sample]++] = fragment.surface;
    for (std::uint32_t sample = 0; sample < samples; ++sample)
        std::sort(
            amongBorder_.fragments.begin() + first[sample], amongBorder_.fragments.begin() + next[sample],
            [](const SurfaceFragment& one, const SurfaceFragment& other) { return one.nearness > other.nearness; });
    first.pop_back();
    amongBorder_.empty = border_.empty();
}

/// First the volume before the regions and their borders, then the fine one in the first region, the volume up to the
/// next, and so on; what is in a border on the way, as surfaces are.
void VolumeTilePainter::drawWithFocus(const SampleRectangle& tile, std::span<const BinnedCell> cells,
                                      const TileSurroundings& surroundings, const Progress& progress, DrawnTile& drawn)
{
    const FocusTile& focus = *surroundings.focus;
    border_.clear();
    collectBorderOf(tile, cells, focus, false, progress);
    collectBorderOf(tile, focus.cells, focus, true, progress);
    putBorderAmong(tile, surroundings.surfaces);
    TileSurroundings among = surroundings;
    among.surfaces = &amongBorder_;
    setLimits(tile, among);
    TileShading shading = shadingOf(tile, among);
    shading.extras = true;

    const std::vector<BlockLimits> whole = limits_;
    using RayInterval = FocusRays::RayInterval;
    /// The number-th of a ray; of those after the last nothing meets.
    const auto intervalOf = [&](std::size_t number, std::size_t block, std::size_t lane) {
        if (number >= intervals_.size())
            return RayInterval{0, 0, 0, 0};
        const auto& [enter, in, out, leave] = intervals_[number][block];
        return RayInterval{enter[lane], in[lane], out[lane], leave[lane]};
    };
    const auto drawBetween = [&](const SetupSource& source, std::span<const BinnedCell> some, auto&& ends) {
        for (std::size_t block = 0; block < limits_.size(); ++block)
            for (std::size_t lane = 0; lane < 8; ++lane) {
                const auto [front, back] = ends(block, lane);
                limits_[block].front[lane] = std::min(front, whole[block].front[lane]);
                limits_[block].back[lane] = std::max(back, whole[block].back[lane]);
            }
        useSource(shading, source);
        draw(source, some, tile, shading, progress, drawn);
    };
    using Ends = std::pair<float, float>;
    constexpr Ends nothing{-farBound, farBound};
    const bool perspective = view_.perspective;
    for (std::size_t number = 0; number <= intervals_.size(); ++number) {
        drawBetween(source_, cells, [&](std::size_t block, std::size_t lane) -> Ends {
            Ends ends{whole[block].front[lane], whole[block].back[lane]};
            if (number > 0) {
                const RayInterval last = intervalOf(number - 1, block, lane);
                if (!last.meets())
                    return nothing;
                ends.first = focusNearness(last.leave, perspective);
            }
            if (const RayInterval next = intervalOf(number, block, lane); next.meets())
                ends.second = focusNearness(next.enter, perspective);
            return ends;
        });
        if (number < intervals_.size())
            drawBetween(*focus.source, focus.cells, [&](std::size_t block, std::size_t lane) -> Ends {
                const RayInterval here = intervalOf(number, block, lane);
                return here.meets() ? Ends{focusNearness(here.in, perspective), focusNearness(here.out, perspective)}
                                    : nothing;
            });
    }
    finish(tile, shading);
}

} // namespace tetra
