// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/border_fragments.h"

#include "core/render/focus_weight.h"
#include "core/render/volume/block_queue.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

using Eigen::Vector3d;

constexpr double everywhere = std::numeric_limits<double>::infinity();

double distanceFromBox(const Vector3d& place, const Vector3d& halfSize)
{
    return (place.cwiseAbs() - halfSize).cwiseMax(0).norm();
}

} // namespace

FocusRays::FocusRays(std::span<const FocusRegion> regions, const VolumeView& view)
    : perspective_(view.perspective), nearest_(view.perspective ? view.nearest : -everywhere), firstX_(view.firstX()),
      firstY_(view.firstY()), worldFromImage_(view.imageFromWorld.leftCols<3>().inverse())
{
    for (const FocusRegion& region : regions) {
        const RegionShape shape = shapeOf(region);
        PlacedRegion placed{shape.isBall, shape.border, shape.centre};
        if (shape.isBall)
            placed.radius = shape.size.x();
        else
            placed.halfSize = shape.size;
        placed.origin = -(worldFromImage_ * view.imageFromWorld.col(3)) - placed.centre;
        regions_.push_back(placed);
    }
}

FocusRays::Ray FocusRays::rayOf(const PlacedRegion& region, int column, int row) const
{
    const Vector3d place(column + firstX_, row + firstY_, 1);
    if (perspective_)
        return {region.origin, worldFromImage_ * place};
    return {region.origin + worldFromImage_.leftCols<2>() * place.head<2>(), worldFromImage_.col(2)};
}

std::pair<double, double> FocusRays::within(const PlacedRegion& region, const Ray& ray, double margin)
{
    const auto& [start, direction] = ray;
    if (region.isBall) {
        const double squared = direction.squaredNorm();
        const double nearest = -start.dot(direction) / squared;
        const double radius = region.radius + margin;
        const double rest = radius * radius - (start + nearest * direction).squaredNorm();
        const double half = rest > 0 ? std::sqrt(rest / squared) : 0;
        return {nearest - half, nearest + half};
    }
    double first = -everywhere, last = everywhere;
    for (int axis = 0; axis < 3; ++axis) {
        const double size = region.halfSize[axis] + margin;
        if (direction[axis] == 0) {
            if (std::abs(start[axis]) > size)
                return {0, 0};
            continue;
        }
        const double one = (-size - start[axis]) / direction[axis], other = (size - start[axis]) / direction[axis];
        first = std::max(first, std::min(one, other));
        last = std::min(last, std::max(one, other));
    }
    return {first, last};
}

FocusRays::RayInterval FocusRays::intervalOf(const PlacedRegion& region, int column, int row) const
{
    const Ray ray = rayOf(region, column, row);
    const auto [enter, leave] = within(region, ray, region.border);
    if (!(leave > enter && leave > nearest_))
        return {0, 0, 0, 0};
    const auto [in, out] = within(region, ray, 0);
    RayInterval interval{enter, in, out, leave};
    if (!(out > in))
        interval.in = interval.out = (enter + leave) / 2;
    for (double* const place : {&interval.enter, &interval.in, &interval.out})
        *place = std::max(*place, nearest_);
    return interval;
}

namespace {

/// What the intervals of several regions are together.
std::vector<FocusRays::RayInterval> joined(std::vector<FocusRays::RayInterval> all)
{
    using RayInterval = FocusRays::RayInterval;
    std::ranges::sort(all, {}, &RayInterval::in);
    std::vector<RayInterval> together;
    for (std::size_t i = 0; i < all.size();) {
        RayInterval next = all[i];
        for (; i < all.size() && all[i].in <= next.out; ++i)
            next.out = std::max(next.out, all[i].out);
        next.enter = next.in;
        next.leave = next.out;
        for (std::size_t round = 0; round < all.size(); ++round)
            for (const RayInterval& one : all) {
                if (one.enter < next.enter && one.leave >= next.enter)
                    next.enter = one.enter;
                if (one.enter <= next.leave && one.leave > next.leave)
                    next.leave = one.leave;
            }
        if (!together.empty() && together.back().leave >= next.in)
            together.back().leave = next.enter = (together.back().out + next.in) / 2;
        together.push_back(next);
    }
    return together;
}

} // namespace

void FocusRays::intervalsAt(int column, int row, std::vector<RayInterval>& intervals) const
{
    intervals.clear();
    for (const PlacedRegion& region : regions_)
        if (const RayInterval interval = intervalOf(region, column, row); interval.meets())
            intervals.push_back(interval);
    if (intervals.size() > 1)
        intervals = joined(std::move(intervals));
}

FocusWeights FocusRays::weightsFrom(const PlacedRegion& region, int column, int row) const
{
    constexpr double steepest = 1e30;
    const Ray first = rayOf(region, column, row), right = rayOf(region, column + 1, row),
              below = rayOf(region, column, row + 1);
    FocusWeights weights;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        const auto affine = [&](FocusWeights::Affine& to, const Vector3d Ray::*part) {
            to.origin[axis] = static_cast<float>((first.*part)[i]);
            to.perColumn[axis] = static_cast<float>((right.*part)[i] - (first.*part)[i]);
            to.perRow[axis] = static_cast<float>((below.*part)[i] - (first.*part)[i]);
        };
        affine(weights.start, &Ray::start);
        affine(weights.direction, &Ray::direction);
        weights.halfSize[axis] = static_cast<float>(region.halfSize[i]);
    }
    weights.radius = static_cast<float>(region.radius);
    weights.perBorder = static_cast<float>(region.border > 0 ? std::min(1 / region.border, steepest) : steepest);
    return weights;
}

std::vector<FocusWeights> FocusRays::weightsFrom(int column, int row) const
{
    std::vector<FocusWeights> weights;
    for (const PlacedRegion& region : regions_)
        weights.push_back(weightsFrom(region, column, row));
    return weights;
}

bool FocusRays::holds(const std::array<std::uint32_t, 4>& cell, std::span<const Eigen::Vector3d> positions) const
{
    return std::ranges::any_of(regions_, [&](const PlacedRegion& region) {
        return std::ranges::all_of(cell, [&](std::uint32_t vertex) {
            const Vector3d fromCentre = positions[vertex] - region.centre;
            return region.isBall ? fromCentre.norm() <= region.radius
                                 : distanceFromBox(fromCentre, region.halfSize) == 0;
        });
    });
}

namespace {

/// The border is cut into this many layers along a ray on either side of the region.
constexpr int layers = 4;

/// The rays of a block in a cell; w.
struct CellInterval {
    Float8 enter, leave, slope;
};

TETRA_SIMD_INLINE CellInterval intervalOf(const CellSetup& cell, float x, float y, bool perspective)
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

/// A block of a tile.
struct BlockPlace {
    int column, row;
    float x() const { return static_cast<float>(column * blockWidth); }
    float y() const { return static_cast<float>(row * blockHeight); }
};

TETRA_SIMD_INLINE Float8 coordinate(const FocusWeights::Affine& affine, std::size_t axis, Float8 x, Float8 y)
{
    return affine.origin[axis] + affine.perColumn[axis] * x + affine.perRow[axis] * y;
}

/// Of the fine volume, at places w along the rays of a block.
TETRA_SIMD_INLINE Float8 weightsAt(const FocusWeights& focus, const BlockPlace& place, Float8 w)
{
    const Float8 x = laneX + place.x(), y = laneY + place.y();
    const Float8 nothing = {};
    Float8 squared = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Float8 at = coordinate(focus.start, axis, x, y) + w * coordinate(focus.direction, axis, x, y);
        const Float8 outside = larger(larger(at, -at) - focus.halfSize[axis], nothing);
        squared += outside * outside;
    }
    Float8 distance;
    for (int lane = 0; lane < 8; ++lane)
        distance[lane] = std::sqrt(squared[lane]);
    return larger(1.0f - larger(distance - focus.radius, nothing) * focus.perBorder, nothing);
}

/// Shades the rays of a block from `from` to `to`, where that is positive, and adds what they gather.
template <bool perspective>
TETRA_SIMD_INLINE void collectLayer(const CellSetup& cell, bool fine, const BorderTile& tile, const BlockPlace& place,
                                    Float8 slope, Float8 from, Float8 to, std::vector<BorderFragment>& fragments)
{
    const SampleBlock& block = tile.blocks[static_cast<std::size_t>(place.row * tile.columns + place.column)];
    const Float8 ones = Float8{} + 1.0f, nothing = {};
    const Float8 middle = (from + to) * 0.5f;
    Float8 ofFine = {};
    for (const FocusWeights& region : tile.weights)
        ofFine = larger(ofFine, weightsAt(region, place, middle));
    const Float8 weight = fine ? ofFine : ones - ofFine;
    const Float8 perFrom = from > nothing ? 1.0f / from : ones, perTo = to > nothing ? 1.0f / to : ones;
    const Float8 front = to > from ? (perspective ? perFrom : -from) : ones;
    const Float8 back = to > from ? (perspective ? perTo : -to) : ones;
    // A part of the optical depth is that of a part of the way.
    CellRays<Float8> rays = {front, back, slope, block.ray * weight, {}, {}};
    Gathered<Float8> gathered = {{}, {}, {}, ones};
    if (tile.shading.lit)
        shadeLit<perspective>(rays, cell, tile.shading.segments, gathered,
                              litRays(tile.shading, laneX + place.x(), laneY + place.y(), block.ray));
    else
        shade<perspective>(rays, cell, tile.shading.segments, gathered);
    for (int lane = 0; lane < 8; ++lane)
        if (to[lane] > from[lane] && gathered.transmittance[lane] < 1) {
            const int x = place.column * blockWidth + lane % blockWidth;
            const int y = place.row * blockHeight + lane / blockWidth;
            fragments.push_back(
                {static_cast<std::uint32_t>(y * tile.tile.width() + x),
                 {perspective ? 1 / middle[lane] : -middle[lane],
                  {gathered.red[lane], gathered.green[lane], gathered.blue[lane], 1 - gathered.transmittance[lane]}}});
        }
}

/// The border from `first` to `last` on one side of the region.
template <bool perspective> TETRA_SIMD_INLINE void collectSide(const CellSetup& cell, bool fine, const BorderTile& tile,
                                                               const BlockPlace& place, const CellInterval& interval,
                                                               Float8 first, Float8 last,
                                                               std::vector<BorderFragment>& fragments)
{
    const Float8 from = larger(first, interval.enter), to = smaller(last, interval.leave);
    if (!anyPositive(to - from))
        return;
    const Float8 step = (last - first) * (1.0f / layers);
    float before = layers, after = 0; // layers that the cell does not reach
    for (int lane = 0; lane < 8; ++lane)
        if (to[lane] > from[lane]) {
            before = std::min(before, (from[lane] - first[lane]) / step[lane]);
            after = std::max(after, (to[lane] - first[lane]) / step[lane]);
        }
    const int begin = std::clamp(static_cast<int>(before), 0, layers - 1);
    const int end = std::clamp(static_cast<int>(std::ceil(after)), begin + 1, layers);
    for (int layer = begin; layer < end; ++layer) {
        const auto number = static_cast<float>(layer);
        const Float8 start = layer == begin ? from : larger(from, first + number * step);
        const Float8 stop = layer == end - 1 ? to : smaller(to, first + (number + 1) * step);
        if (anyPositive(stop - start))
            collectLayer<perspective>(cell, fine, tile, place, interval.slope, start, stop, fragments);
    }
}

template <bool perspective> TETRA_SIMD_INLINE void collectBlock(const CellSetup& cell, bool fine,
                                                                const BorderTile& tile, const BlockPlace& place,
                                                                std::vector<BorderFragment>& fragments)
{
    const BlockInterval& region = tile.intervals[static_cast<std::size_t>(place.row * tile.columns + place.column)];
    if (!anyPositive(region.leave - region.enter))
        return;
    const CellInterval interval = intervalOf(cell, place.x(), place.y(), perspective);
    collectSide<perspective>(cell, fine, tile, place, interval, region.enter, region.in, fragments);
    collectSide<perspective>(cell, fine, tile, place, interval, region.out, region.leave, fragments);
}

TETRA_SIMD_INLINE void collect(std::span<const CellSetup> cells, bool fine, const BorderTile& tile,
                               std::vector<BorderFragment>& fragments)
{
    for (const CellSetup& cell : cells) {
        if (cell.flat)
            continue;
        for (int row = cell.top; row < cell.bottom; ++row)
            for (int column = cell.left; column < cell.right; ++column)
                if (tile.shading.perspective)
                    collectBlock<true>(cell, fine, tile, {column, row}, fragments);
                else
                    collectBlock<false>(cell, fine, tile, {column, row}, fragments);
    }
}

} // namespace

void collectBorder(std::span<const CellSetup> cells, bool fine, const BorderTile& tile,
                   std::vector<BorderFragment>& fragments)
{
    dispatch<collect>(cells, fine, tile, fragments);
}

} // namespace tetra
