// SPDX-License-Identifier: GPL-3.0-or-later
// The part of VolumeTilePainter that draws a finer volume inside a region (R24).
#include "core/graphics/volume/block_lane.h"
#include "core/graphics/volume/tile_picture.h"

#include <algorithm>

namespace tetra {
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

/// The whole cell lies in the region, so that none of it is in the border.
bool liesWithin(const std::array<std::uint32_t, 4>& cell, std::span<const Eigen::Vector3f> positions,
                const FocusRays& rays)
{
    return std::ranges::all_of(cell, [&](std::uint32_t vertex) { return rays.holds(positions[vertex]); });
}

} // namespace

/// False if no ray of the tile meets the focus. What clip planes hide is left out of the passages.
bool VolumeTilePainter::setPassages(const SampleRectangle& tile, const FocusRays& rays)
{
    passages_.assign(blocks_.size(), BlockPassage{{}, {}, {}, {}});
    bool any = false;
    for (int y = 0; y < tile.height(); ++y)
        for (int x = 0; x < tile.width(); ++x) {
            FocusRays::Passage passage = rays.at(tile.left + x, tile.top + y);
            if (!passage.meets())
                continue;
            const auto [number, lane] = BlockLane(x, y);
            const double front = limits_[number].front[lane], back = limits_[number].back[lane];
            const bool perspective = view_.perspective;
            const double nearest = perspective ? 1 / std::max<double>(front, 1e-30) : -front;
            const double farthest = !perspective ? -back : back > 0 ? 1 / back : double(farBound);
            const auto shown = [&](double w) {
                return static_cast<float>(std::max(nearest, std::min(w, std::max(nearest, farthest))));
            };
            passages_[number].enter[lane] = shown(passage.enter);
            passages_[number].in[lane] = shown(passage.in);
            passages_[number].out[lane] = shown(passage.out);
            passages_[number].leave[lane] = shown(passage.leave);
            any = true;
        }
    return any;
}

void VolumeTilePainter::collectBorderOf(const SampleRectangle& tile, std::span<const BinnedCell> cells,
                                        const FocusTile& focus, bool fine, const Progress& progress)
{
    const SetupSource& source = fine ? *focus.source : source_;
    const auto positions = fine ? focus.finePositions : focus.positions;
    const BorderTile border{focus.rays->weightsFrom(tile.left, tile.top),
                            tile,
                            passages_,
                            blocks_,
                            volumeTileSide / blockWidth,
                            source.segments.data(),
                            view_.perspective};
    const TileFrame frame = frameOf(tile);
    std::vector<BinnedCell> outside;
    for (std::size_t first = 0; first < cells.size() && !progress.cancelled(); first += borderBatch) {
        outside.clear();
        for (const BinnedCell& cell : cells.subspan(first, std::min(borderBatch, cells.size() - first)))
            if (!liesWithin(source.tetrahedra[cell.cell], positions, *focus.rays))
                outside.push_back(cell);
        setUpCells(source, frame, outside, setups_);
        collectBorder(std::span(setups_).first(outside.size()), fine, border, border_);
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

/// First the volume before the region and its border, then the fine one in the region, and the volume behind; what is
/// in the border on the way, as surfaces are.
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
    TileShading shading = shadingOf(among);
    shading.extras = true;

    const std::vector<BlockLimits> whole = limits_;
    const auto drawBetween = [&](const SetupSource& source, std::span<const BinnedCell> some, auto&& ends) {
        for (std::size_t block = 0; block < limits_.size(); ++block)
            for (std::size_t lane = 0; lane < 8; ++lane) {
                const auto& [enter, in, out, leave] = passages_[block];
                const FocusRays::Passage passage{enter[lane], in[lane], out[lane], leave[lane]};
                const auto [front, back] = ends(passage, whole[block].front[lane], whole[block].back[lane]);
                limits_[block].front[lane] = std::min(front, whole[block].front[lane]);
                limits_[block].back[lane] = std::max(back, whole[block].back[lane]);
            }
        shading.segments = source.segments.data();
        draw(source, some, tile, shading, progress, drawn);
    };
    using Ends = std::pair<float, float>;
    constexpr Ends nothing{-farBound, farBound};
    const bool perspective = view_.perspective;
    drawBetween(source_, cells, [&](const FocusRays::Passage& passage, float front, float back) -> Ends {
        return {front, passage.meets() ? focusNearness(passage.enter, perspective) : back};
    });
    drawBetween(*focus.source, focus.cells, [&](const FocusRays::Passage& passage, float, float) -> Ends {
        return passage.meets() ? Ends{focusNearness(passage.in, perspective), focusNearness(passage.out, perspective)}
                               : nothing;
    });
    drawBetween(source_, cells, [&](const FocusRays::Passage& passage, float, float back) -> Ends {
        return passage.meets() ? Ends{focusNearness(passage.leave, perspective), back} : nothing;
    });
    finish(tile, shading);
}

} // namespace tetra
