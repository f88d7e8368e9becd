// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/ray_casting.h"

#include "core/render/shading.h"
#include "core/render/volume/block_shading.h"
#include "core/render/volume/trilinear_samples.h"
#include "core/render/volume/volume_mesh.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tetra {
namespace {

/// Where the rays of a block are: at + along * w.
struct BlockRays {
    Places at, along;
    Float8 enter, leave; ///< w, between which they are in the lattice and shown
};

TETRA_SIMD_INLINE void placesAt(const BlockRays& rays, Float8 w, Places& places)
{
    places = {rays.at.x + rays.along.x * w, rays.at.y + rays.along.y * w, rays.at.z + rays.along.z * w};
}

TETRA_SIMD_INLINE float leastOf(Float8 values)
{
    float least = values[0];
    for (int lane = 1; lane < placesAtOnce; ++lane)
        least = std::min(least, values[lane]);
    return least;
}
TETRA_SIMD_INLINE float largestOf(Float8 values)
{
    return -leastOf(-values);
}

/// Where rays meet the layers 0 and `last` of the lattice along one axis; of those along the layers far away.
TETRA_SIMD_INLINE void crossAxis(Float8 at, Float8 along, float last, Float8& enter, Float8& leave)
{
    constexpr float still = 1e-20f;
    const Float8 moving = larger(along, -along) < still ? Float8{} + still : along;
    const Float8 first = -at / moving, other = (last - at) / moving;
    enter = larger(enter, smaller(first, other));
    leave = smaller(leave, larger(first, other));
}

/// The w of a q (CellSetup).
TETRA_SIMD_INLINE Float8 distanceOf(Float8 nearness, bool perspective)
{
    if (!perspective)
        return -nearness;
    return 1.0f / larger(nearness, Float8{} + 1 / farBound);
}

TETRA_SIMD_INLINE void findRays(const SampledView& view, const TileShading& shading, Float8 x, Float8 y,
                                const BlockLimits* limits, BlockRays& rays)
{
    const auto& matrix = view.indexFromImage;
    const Float8 right = x + shading.firstX, down = y + shading.firstY;
    const auto across = [&](int axis) { return matrix(axis, 0) * right + matrix(axis, 1) * down; };
    Float8* const at[] = {&rays.at.x, &rays.at.y, &rays.at.z};
    Float8* const along[] = {&rays.along.x, &rays.along.y, &rays.along.z};
    rays.enter = distanceOf(limits != nullptr ? limits->front : Float8{} + shading.nearestBound, shading.perspective);
    rays.leave = distanceOf(limits != nullptr ? limits->back : Float8{} - farBound, shading.perspective);
    for (int axis = 0; axis < 3; ++axis) {
        const Float8 fixed = Float8{} + matrix(axis, 3), moving = Float8{} + matrix(axis, 2);
        *at[axis] = shading.perspective ? fixed : fixed + across(axis);
        *along[axis] = shading.perspective ? moving + across(axis) : moving;
        crossAxis(*at[axis], *along[axis], static_cast<float>(view.field->lattice.size[std::size_t(axis)] - 1),
                  rays.enter, rays.leave);
    }
}

/// The distance of the block that each lane's cell is in, and the w where the rays leave the blocks around it in which
/// nothing is seen.
template <class Mask>
TETRA_SIMD_INLINE Float8 darkUntil(const SampledView& view, const BlockRays& rays, Float8 w, Mask active)
{
    constexpr float side = sampleBlockSide;
    const auto& blocks = view.field->blocks;
    Places places;
    placesAt(rays, w, places);
    const Float8* const at[] = {&places.x, &places.y, &places.z};
    const Float8* const along[] = {&rays.along.x, &rays.along.y, &rays.along.z};
    Float8 block[3];
    for (std::size_t axis = 0; axis < 3; ++axis)
        block[axis] = cellAlong(*at[axis] * (1 / side), static_cast<float>(blocks[axis]));
    Float8 distance;
    for (int lane = 0; lane < placesAtOnce; ++lane) {
        const auto number = (std::uint64_t(block[2][lane]) * blocks[1] + std::uint64_t(block[1][lane])) * blocks[0] +
                            std::uint64_t(block[0][lane]);
        distance[lane] = active[lane] ? view.transfer->distances[number] : 255;
    }
    Float8 leave = Float8{} + farBound;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        constexpr float still = 1e-20f;
        const Float8 upper = (block[axis] + distance) * side, lower = (block[axis] + 1.0f - distance) * side;
        const Float8 moving = larger(*along[axis], -*along[axis]) < still ? Float8{} + still : *along[axis];
        const Float8 edge = moving > 0 ? upper : lower;
        leave = smaller(leave, w + (edge - *at[axis]) / moving);
    }
    return distance > 0 ? leave : w;
}

/// The w at which a step begins; steps are numbered from the eye. Numbers are in double precision: of a camera that is
/// very far away single precision would not know one from the next.
TETRA_SIMD_INLINE float placeOfStep(const SampledView& view, double number)
{
    return static_cast<float>(number * view.step);
}

/// How many steps from this one may be passed by, as nothing is seen on any ray.
TETRA_SIMD_INLINE double darkSteps(const SampledView& view, const BlockRays& rays, double number, Float8 transmittance)
{
    const Float8 w = smaller(larger(Float8{} + placeOfStep(view, number), rays.enter), rays.leave);
    const auto active = (w < rays.leave) & (transmittance > opaqueThreshold);
    const Float8 until = darkUntil(view, rays, w, active);
    const float place = leastOf(active ? smaller(until, rays.leave) : Float8{} + farBound);
    return std::floor(double(place) / view.step) - number;
}

/// The segment of a scaled value.
TETRA_SIMD_INLINE std::size_t segmentAt(const SampledView& view, float value)
{
    const auto parts = static_cast<float>(view.segmentOfPart.size());
    const float part = std::min(std::max(value * parts, 0.0f), parts - 1);
    std::size_t segment = value < 0 ? 0 : view.segmentOfPart[static_cast<std::size_t>(part)];
    while (segment + 1 < view.scaled.segments.size() && value >= view.scaled.segments[segment].end)
        ++segment;
    return segment;
}

/// Where the rays of a block are, and what is known there.
struct Walk {
    Float8 w, value;         ///< values are scaled
    std::size_t segment = 0; ///< that the values were in last
};

/// The light at a place of each ray.
struct LitPlace {
    Float8 w;
    LightThere<Float8> light;
};

/// The light between two places is affine. Stretches of that length are numbered from the eye.
struct LitStretch {
    LitPlace from, to;
    double number = -1; ///< none is known
};

/// What a slab of a step lies in: the segments of the values of all rays.
struct StepSegments {
    std::size_t first, last;
    bool transparent;
};

TETRA_SIMD_INLINE StepSegments segmentsOf(const SampledView& view, Walk& walk, Float8 to, Float8 value)
{
    const ScaledSegment& same = view.scaled.segments[walk.segment];
    const auto moves = to > walk.w;
    const Float8 low = moves ? smaller(walk.value, value) : Float8{} + same.begin;
    const Float8 high = moves ? larger(walk.value, value) : Float8{} + same.begin;
    if (!any((low < same.begin) | (high > same.end)))
        return {walk.segment, walk.segment, same.transparent};
    const Float8 farAway = Float8{} + farBound;
    StepSegments among{segmentAt(view, leastOf(moves ? low : farAway)),
                       segmentAt(view, largestOf(moves ? high : -farAway)), true};
    among.last = std::max(among.first, among.last);
    for (std::size_t i = among.first; i <= among.last; ++i)
        among.transparent = among.transparent && view.scaled.segments[i].transparent;
    walk.segment = among.last;
    return among;
}

TETRA_SIMD_INLINE Thickness thicknessOf(float depth)
{
    return depth <= faintDepth ? Thickness::Faint : depth <= 1 ? Thickness::Thin : Thickness::Thick;
}

template <class Light> TETRA_SIMD_INLINE void addStep(const SampledView& view, const StepSegments& among, Float8 in,
                                                      Float8 out, Float8 length, float longest, const Light& light,
                                                      Gathered<Float8>& gathered)
{
    const ScaledSegment* const segments = view.scaled.segments.data();
    float extinction = 0;
    for (std::size_t i = among.first; i <= among.last; ++i)
        extinction = std::max(extinction, segments[i].largestExtinction);
    const Thickness thickness = thicknessOf(extinction * longest);
    if (among.first == among.last) {
        const ScaledSegment& segment = segments[among.first];
        return addSlab(gathered, segment, thickness, in - segment.origin, out - segment.origin, length, light, Float8{},
                       Float8{} + 1.0f);
    }
    CellSetup cell;
    cell.smallest = -farBound;
    cell.largest = farBound;
    cell.firstSegment = static_cast<std::uint16_t>(among.first);
    cell.lastSegment = static_cast<std::uint16_t>(among.last);
    cell.thickness = thickness;
    cell.direction = !any(out < in) ? Direction::Rising : !any(out > in) ? Direction::Falling : Direction::Mixed;
    addSlices(gathered, segments, cell, in, out, length, light);
}

/// Casts the rays of one block through the samples. `lit`: with the gradients of the view.
template <class Value, bool lit> class BlockCasting {
public:
    TETRA_SIMD_INLINE BlockCasting(const SampledView& view, const TileShading& shading, SampleBlock& block,
                                   BlockLimits* limits, int column, int row)
        : view_(view), shading_(shading), block_(block), limits_(limits),
          samples_(view.field->values.as<Value>().data())
    {
        const Float8 x = laneX + static_cast<float>(column * blockWidth);
        const Float8 y = laneY + static_cast<float>(row * blockHeight);
        findRays(view, shading, x, y, limits, rays_);
        if constexpr (lit) {
            lit_ = litRays(shading, x, y, block.ray);
            lit_.perFullGradient = view.perFullGradient;
        }
        gathered_ = {block.red, block.green, block.blue, block.transmittance};
        longest_ = view.step * largestOf(block.ray);
    }

    TETRA_SIMD_INLINE void run()
    {
        const auto active = (rays_.enter < rays_.leave) & (gathered_.transmittance > opaqueThreshold);
        if (!any(active))
            return;
        const Float8 farAway = Float8{} + farBound;
        const float end = largestOf(active ? rays_.leave : -farAway);
        double number = std::floor(double(leastOf(active ? rays_.enter : farAway)) / view_.step);
        bool dark = true, known = false;
        while (number * view_.step < double(end)) {
            if (dark)
                if (const double passed = darkSteps(view_, rays_, number, gathered_.transmittance); passed >= 1) {
                    number += passed;
                    known = false;
                    continue;
                }
            if (!known)
                start(bounded(number));
            dark = !step(number);
            known = true;
            number += 1;
            if (!any((walk_.w < rays_.leave) & (gathered_.transmittance > opaqueThreshold)))
                break;
        }
        store(block_, gathered_.red, gathered_.green, gathered_.blue, gathered_.transmittance);
    }

private:
    TETRA_SIMD_INLINE Float8 bounded(double number) const
    {
        return smaller(larger(Float8{} + placeOfStep(view_, number), rays_.enter), larger(rays_.enter, rays_.leave));
    }

    TETRA_SIMD_INLINE Float8 scaledValues(const CellCornersOfPlaces& cells) const
    {
        return (valuesAt(samples_, view_.field->lattice, cells) - smallest_) * perValue_;
    }

    TETRA_SIMD_INLINE void cellsAt(Float8 w, CellCornersOfPlaces& cells) const
    {
        Places places;
        placesAt(rays_, w, places);
        findCells(view_.field->lattice, places, cells);
    }

    TETRA_SIMD_INLINE void start(Float8 w)
    {
        CellCornersOfPlaces cells;
        cellsAt(w, cells);
        walk_.w = w;
        walk_.value = scaledValues(cells);
    }

    TETRA_SIMD_INLINE void lightAtPlace(Float8 w, LitPlace& place) const
    {
        constexpr float leastSquare = 1; // of steps of SampleGradients
        CellCornersOfPlaces cells;
        cellsAt(w, cells);
        SeenGradients seen;
        gradientsAt(*view_.gradients, view_.field->lattice, view_.seenFromWorld, cells, seen);
        place.w = w;
        lightOnGradient(seen.right, seen.down, seen.away, leastSquare, lit_, place.light);
    }

    /// Knows the light around step `number`.
    TETRA_SIMD_INLINE void findLight(double number)
    {
        const double stretch = std::floor(number / view_.stepsPerLight);
        if (stretch == stretch_.number)
            return;
        if (stretch == stretch_.number + 1 && stretch_.number >= 0)
            stretch_.from = stretch_.to;
        else
            lightAtPlace(bounded(stretch * view_.stepsPerLight), stretch_.from);
        lightAtPlace(bounded((stretch + 1) * view_.stepsPerLight), stretch_.to);
        stretch_.number = stretch;
    }

    /// Takes step `number`. Whether anything was seen.
    TETRA_SIMD_INLINE bool step(double number)
    {
        const Float8 to = bounded(number + 1);
        if (shading_.fragments != nullptr)
            while (meetSurfaces(number, to)) {
            }
        return walkTo(number, to);
    }

    /// Those rays that meet a surface before `to` go up to it, and through it. Whether there was any.
    TETRA_SIMD_INLINE bool meetSurfaces(double number, Float8 to)
    {
        const Float8 next = distanceOf(limits_->next, shading_.perspective);
        const auto meets = (limits_->next > -farBound) & (next < to) & (gathered_.transmittance > opaqueThreshold);
        if (!any(meets))
            return false;
        walkTo(number, meets ? larger(next, walk_.w) : walk_.w);
        store(block_, gathered_.red, gathered_.green, gathered_.blue, gathered_.transmittance);
        for (int lane = 0; lane < placesAtOnce; ++lane)
            if (meets[lane])
                drawSurface(shading_.fragments, shading_.perspective, std::size_t(lane), block_, *limits_);
        gathered_ = {block_.red, block_.green, block_.blue, block_.transmittance};
        return true;
    }

    TETRA_SIMD_INLINE bool walkTo(double number, Float8 to)
    {
        CellCornersOfPlaces cells;
        cellsAt(to, cells);
        const Float8 value = scaledValues(cells);
        const StepSegments among = segmentsOf(view_, walk_, to, value);
        const Float8 before = gathered_.transmittance;
        if (!among.transparent)
            addLight(number, to, value, among);
        const bool seen = !among.transparent && any(gathered_.transmittance < before);
        walk_.w = to;
        walk_.value = value;
        return seen;
    }

    TETRA_SIMD_INLINE void addLight(double number, Float8 to, Float8 value, const StepSegments& among)
    {
        const Float8 length = (to - walk_.w) * block_.ray;
        block_.transmittance = gathered_.transmittance; // keepDepth() wants that before
        if constexpr (lit)
            addLit(number, to, value, among, length);
        else
            addStep(view_, among, walk_.value, value, length, longest_, NoLight(), gathered_);
        if (shading_.depth)
            keepDepth(block_, 0, gathered_.transmittance, walk_.w, to);
    }

    TETRA_SIMD_INLINE void addLit(double number, Float8 to, Float8 value, const StepSegments& among, Float8 length)
    {
        constexpr float least = 1e-20f;
        findLight(number);
        const auto& [from, end, stretch] = stretch_;
        const Float8 perUnit = 1.0f / larger(end.w - from.w, Float8{} + least);
        const Float8 shareIn = (walk_.w - from.w) * perUnit, share = (to - walk_.w) * perUnit;
        const auto& [factor, highlight, seen] = from.light;
        const Float8 factorRise = end.light.factor - factor, highlightRise = end.light.highlight - highlight;
        const Float8 seenRise = end.light.share - seen;
        const LightAlong<Float8> light{factor + factorRise * shareIn,       factorRise * share,
                                       highlight + highlightRise * shareIn, highlightRise * share,
                                       seen + seenRise * shareIn,           seenRise * share};
        addStep(view_, among, walk_.value, value, length, longest_, light, gathered_);
    }

    const SampledView& view_;
    const TileShading& shading_;
    SampleBlock& block_;
    BlockLimits* limits_;
    const Value* samples_;
    float smallest_ = static_cast<float>(view_.scaled.smallest);
    float perValue_ = static_cast<float>(view_.scaled.perValue);
    float longest_ = 0; ///< a step, along the ray, in units of w
    BlockRays rays_;
    LitRays<Float8> lit_;
    Gathered<Float8> gathered_;
    Walk walk_{};
    LitStretch stretch_{};
};

template <class Value, bool lit> TETRA_SIMD_INLINE void castBlocks(const SampledView& view, const TileShading& shading,
                                                                   SampleBlock* blocks, int columns, int rows)
{
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const auto number = std::size_t(row * columns + column);
            BlockLimits* const limits = shading.limits != nullptr ? shading.limits + number : nullptr;
            BlockCasting<Value, lit>(view, shading, blocks[number], limits, column, row).run();
        }
}

/// The indices of the lattice at a place of the view.
Eigen::Matrix<double, 3, 4> indexFromImage(const Lattice& lattice, const VolumeView& view)
{
    const Eigen::Matrix3d indexFromWorld = (lattice.directions * lattice.spacing.asDiagonal()).inverse();
    const Eigen::Matrix3d worldFromImage = view.imageFromWorld.leftCols<3>().inverse();
    Eigen::Matrix<double, 3, 4> matrix;
    matrix.leftCols<3>() = indexFromWorld * worldFromImage;
    matrix.col(3) = -indexFromWorld * (worldFromImage * view.imageFromWorld.col(3) + lattice.origin);
    return matrix;
}

/// How many steps a ray takes through a cell: the field bends within a step, and what of that is seen grows with the
/// optical depth of a step and falls with the square of the number.
float stepsPerCell(const ScaledSegments& scaled, float cellLength)
{
    constexpr float fewest = 2, most = 48, perRootOfDepth = 13;
    float extinction = 0;
    for (const ScaledSegment& segment : scaled.segments)
        extinction = std::max(extinction, segment.largestExtinction);
    return std::clamp(std::ceil(perRootOfDepth * std::sqrt(extinction * cellLength) / 2) * 2, fewest, most);
}

} // namespace

SampledView makeSampledView(const SampledVolume& volume, const VolumeView& view)
{
    constexpr std::size_t parts = 1024;
    const Eigen::Matrix<double, 3, 4> matrix = indexFromImage(volume.samples->lattice, view);
    SampledView result;
    result.field = volume.samples.get();
    result.transfer = volume.transfer.get();
    result.gradients = volume.gradients.get();
    if (volume.gradients)
        result.perFullGradient = perFullGradient(volume.fullGradient, volume.gradients->unit);
    result.scaled = scaleSegments(volume.transfer->segments, view.unit);
    result.indexFromImage = matrix.cast<float>();
    result.seenFromWorld = view.axes();
    const auto cellLength = static_cast<float>(1 / matrix.col(2).cwiseAbs().maxCoeff());
    const float steps = stepsPerCell(result.scaled, cellLength);
    result.step = cellLength / steps;
    result.stepsPerLight = steps > 6 ? 2 : steps / 2;
    result.segmentOfPart.resize(parts);
    std::size_t segment = 0;
    for (std::size_t part = 0; part < parts; ++part) {
        const float least = static_cast<float>(part) / parts;
        while (segment + 1 < result.scaled.segments.size() && result.scaled.segments[segment].end <= least)
            ++segment;
        result.segmentOfPart[part] = static_cast<std::uint16_t>(segment);
    }
    return result;
}

void castRays(const SampledView& view, const TileShading& shading, SampleBlock* blocks, int columns, int rows)
{
    const auto cast = [&]<class Value>(Value) {
        if (view.gradients != nullptr)
            dispatch<castBlocks<Value, true>>(view, shading, blocks, columns, rows);
        else
            dispatch<castBlocks<Value, false>>(view, shading, blocks, columns, rows);
    };
    switch (view.field->values.type()) {
    case SampleType::UInt8: return cast(std::uint8_t());
    case SampleType::Int16: return cast(std::int16_t());
    default: return cast(float());
    }
}

} // namespace tetra
