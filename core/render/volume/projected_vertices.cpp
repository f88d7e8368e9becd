// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/projected_vertices.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetra {

namespace {

/// Beyond all scaled values, but far from overflow.
constexpr double farAway = 1e30;

ScaledSegment scaled(const TransferSegment& segment, const ScaledSegments& all, double unit)
{
    const auto scaledValue = [&](double value) {
        return static_cast<float>(std::clamp((value - all.smallest) * all.perValue, -farAway, farAway));
    };
    ScaledSegment result;
    result.begin = scaledValue(segment.begin);
    result.end = scaledValue(segment.end);
    result.origin = scaledValue(segment.origin);
    result.halfExtinction = static_cast<float>(segment.atOrigin.extinction * unit / 2);
    result.halfExtinctionPerValue = static_cast<float>(segment.perValue.extinction / all.perValue * unit / 2);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        result.colour[channel] = static_cast<float>(segment.atOrigin.colour[channel]);
        result.colourPerValue[channel] = static_cast<float>(segment.perValue.colour[channel] / all.perValue);
    }
    const double width = std::isfinite(segment.end - segment.begin) ? segment.end - segment.begin : 0;
    const double atEnd = segment.atOrigin.extinction + width * segment.perValue.extinction;
    result.largestExtinction = static_cast<float>(std::max(segment.atOrigin.extinction, atEnd) * unit);
    result.transparent = segment.transparent();
    return result;
}

} // namespace

ScaledSegments scaleSegments(std::span<const TransferSegment> segments, double unit)
{
    ScaledSegments result;
    for (std::size_t i = 1; i < segments.size(); ++i)
        result.knots.push_back(segments[i].begin);
    if (!result.knots.empty())
        result.smallest = result.knots.front();
    if (result.knots.size() > 1)
        result.perValue = 1 / (result.knots.back() - result.knots.front());
    for (const TransferSegment& segment : segments)
        result.segments.push_back(scaled(segment, result, unit));
    return result;
}

namespace {

/// The first sample, by column or row, not before a place that is measured from sample 0; within 16 bits.
std::int16_t firstSampleFrom(double place) noexcept
{
    // Written so that NaN gives the lower bound.
    const double bounded = place < 32767.0 ? (place > -32767.0 ? place : -32767.0) : 32767.0;
    return static_cast<std::int16_t>(std::ceil(bounded));
}

VertexSample sampleOf(const Eigen::Vector3d& image, const VolumeView& view)
{
    if (view.perspective && !(image.z() > view.nearest))
        return {VertexSample::behind, VertexSample::behind};
    const double scale = view.perspective ? 1 / image.z() : 1;
    return {firstSampleFrom(image.x() * scale - view.firstX()), firstSampleFrom(image.y() * scale - view.firstY())};
}

} // namespace

ProjectedVertices projectVertices(const TetrahedralMesh& mesh, const VolumeView& view, const ScaledSegments& segments)
{
    ProjectedVertices result;
    result.vertices.resize(mesh.positions.size());
    result.samples.resize(mesh.positions.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.positions.size(), 1 << 12), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            const Eigen::Vector3d image = view.imageFromWorld * mesh.positions[i].homogeneous();
            const double value = std::clamp((mesh.values[i] - segments.smallest) * segments.perValue, -1e25, 1e25);
            result.vertices[i] = {static_cast<float>(image.x()), static_cast<float>(image.y()),
                                  static_cast<float>(image.z()), static_cast<float>(value)};
            result.samples[i] = sampleOf(image, view);
        }
    });
    return result;
}

namespace {

/// The smallest rectangle around images, in samples.
struct ImageBounds {
    double low[2] = {1e30, 1e30};
    double high[2] = {-1e30, -1e30};

    void include(const VolumeView& view, double u, double v, double w)
    {
        const double place[2] = {u / w - view.firstX(), v / w - view.firstY()};
        for (int axis = 0; axis < 2; ++axis) {
            low[axis] = std::min(low[axis], place[axis]);
            high[axis] = std::max(high[axis], place[axis]);
        }
    }
};

} // namespace

SampleRectangle boxOfCutCorners(std::span<const std::uint32_t> corners, const ProjectedVertices& projected,
                                const VolumeView& view)
{
    ImageBounds bounds;
    bool seen = false;
    for (const std::uint32_t corner : corners) {
        const ProjectedVertex& a = projected.vertices[corner];
        if (!(a.w > view.nearest))
            continue;
        seen = true;
        bounds.include(view, a.u, a.v, a.w);
        for (const std::uint32_t other : corners) {
            const ProjectedVertex& b = projected.vertices[other];
            if (b.w > view.nearest)
                continue;
            const double share = (a.w - view.nearest) / (double(a.w) - b.w);
            bounds.include(view, a.u + share * (double(b.u) - a.u), a.v + share * (double(b.v) - a.v), view.nearest);
        }
    }
    if (!seen)
        return {};
    // One more on each side, as these are the places of rounded vertices.
    return {firstSampleFrom(bounds.low[0]) - 1, firstSampleFrom(bounds.low[1]) - 1, firstSampleFrom(bounds.high[0]) + 1,
            firstSampleFrom(bounds.high[1]) + 1};
}

namespace {

constexpr std::size_t cellsInChunk = 1 << 15;
constexpr std::size_t cellsFetchedAhead = 24;

struct BoxedCell {
    std::uint32_t cell;
    std::int16_t left, top, right, bottom;
};

/// The cells of a chunk that may cover samples of the picture, and how many of them each tile has.
struct Chunk {
    Buffer<BoxedCell> cells;
    std::vector<std::uint32_t> places;
};

BinnedCell binned(const BoxedCell& boxed, int side, int row, int column)
{
    const int x = column * side, y = row * side;
    const auto byte = [](int number) { return static_cast<std::uint8_t>(number); };
    return {boxed.cell, byte(std::max(boxed.left - x, 0) / blockWidth), byte(std::max(boxed.top - y, 0) / blockHeight),
            byte((std::min(boxed.right - x, side) + blockWidth - 1) / blockWidth),
            byte((std::min(boxed.bottom - y, side) + blockHeight - 1) / blockHeight)};
}

} // namespace

CellBins binCells(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::span<const CellClass> classes,
                  std::span<const std::uint32_t> order, const ProjectedVertices& projected, const VolumeView& view,
                  const TileGrid& grid, const Progress& progress)
{
    const SampleRectangle picture{0, 0, grid.width, grid.height};
    const TileFinder finder(grid);
    const int side = grid.side;
    std::vector<Chunk> chunks((order.size() + cellsInChunk - 1) / cellsInChunk);
    tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t index) {
        Chunk& chunk = chunks[index];
        chunk.places.assign(grid.count(), 0);
        if (progress.cancelled())
            return;
        const auto ofChunk =
            order.subspan(index * cellsInChunk, std::min(cellsInChunk, order.size() - index * cellsInChunk));
        chunk.cells.resize(ofChunk.size());
        std::size_t count = 0;
        for (std::size_t i = 0; i < ofChunk.size(); ++i) {
            // Orders jump about; what the processor cannot guess is fetched ahead.
            const std::uint32_t ahead = ofChunk[std::min(i + cellsFetchedAhead, ofChunk.size() - 1)];
            __builtin_prefetch(&tetrahedra[ahead]);
            __builtin_prefetch(&classes[ahead]);
            const std::uint32_t cell = ofChunk[i];
            if (!classes[cell].visible())
                continue;
            const SampleRectangle box = intersection(boxOf(std::span(tetrahedra[cell]), projected, view), picture);
            if (isEmpty(box))
                continue;
            const auto place = [](int number) { return static_cast<std::int16_t>(number); };
            const BoxedCell boxed = {cell, place(box.left), place(box.top), place(box.right), place(box.bottom)};
            chunk.cells[count++] = boxed;
            forEachTileOf(box, finder, [&](int row, int column) { ++chunk.places[finder.numberOf(row, column)]; });
        }
        chunk.cells.resize(count);
    });

    CellBins bins;
    bins.first.push_back(0);
    for (std::size_t tile = 0; tile < grid.count(); ++tile) {
        // Places inside a tile fit 32 bits: it has every cell at most once.
        std::uint32_t place = 0;
        for (Chunk& chunk : chunks)
            place += std::exchange(chunk.places[tile], place);
        bins.first.push_back(bins.first.back() + place);
    }
    bins.cells.resize(bins.first.back());
    tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t index) {
        Chunk& chunk = chunks[index];
        for (const BoxedCell& boxed : chunk.cells)
            forEachTileOf({boxed.left, boxed.top, boxed.right, boxed.bottom}, finder, [&](int row, int column) {
                const std::size_t tile = finder.numberOf(row, column);
                bins.cells[bins.first[tile] + chunk.places[tile]++] = binned(boxed, side, row, column);
            });
    });
    return bins;
}

} // namespace tetra
