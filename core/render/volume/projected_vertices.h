// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"
#include "core/render/order/cell_geometry.h"
#include "core/render/tiles.h"
#include "core/render/volume/volume_mesh.h"
#include "core/render/volume/volume_view.h"

#include <tan/base.h>
#include <tan/mesh.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// A segment of the transfer function for the kernels: in single precision, over scaled values, from the segment's
/// origin. Lengths are those of w (VolumeView).
struct ScaledSegment {
    float begin = 0; ///< scaled values; finite, but beyond all values at the ends
    float end = 0;
    float origin = 0;
    float halfExtinction = 0; ///< at the origin, like the colour
    float halfExtinctionPerValue = 0;
    float colour[3] = {};
    float colourPerValue[3] = {};
    float largestExtinction = 0;
    bool transparent = true;
};

/// The segments of a function over values that are scaled so that its knots lie in [0, 1].
struct ScaledSegments {
    std::vector<ScaledSegment> segments;
    std::vector<double> knots; ///< where segments meet, unscaled
    double smallest = 0;       ///< (value - smallest) * perValue is the scaled value
    double perValue = 1;
};

/// `unit`: the length of w = 1 (VolumeView), in the units of the dataset.
ScaledSegments scaleSegments(std::span<const TransferSegment> segments, double unit);

/// The first sample that does not lie before a vertex, by column and row; `behind` if it is nearer than the near plane.
struct VertexSample {
    static constexpr std::int16_t behind = -32768;
    std::int16_t column;
    std::int16_t row;
    bool isBehind() const noexcept { return column == behind; }
};

/// A mesh's vertices in a picture of at most largestPictureSide samples a side.
struct ProjectedVertices {
    Buffer<ProjectedVertex> vertices;
    Buffer<VertexSample> samples;
};

/// O(vertices), on all threads of the current arena. May throw std::bad_alloc.
ProjectedVertices projectVertices(const TetrahedralMesh& mesh, const VolumeView& view, const ScaledSegments& segments);

/// The samples that the hull of vertices on both sides of the near plane may cover; empty if none is before it.
SampleRectangle boxOfCutCorners(std::span<const std::uint32_t> corners, const ProjectedVertices& projected,
                                const VolumeView& view);

/// The samples that the hull of a cell's or a face's corners may cover; not clipped to the picture.
template <std::size_t count> SampleRectangle boxOf(std::span<const std::uint32_t, count> corners,
                                                   const ProjectedVertices& projected, const VolumeView& view)
{
    using Short8 = std::int16_t __attribute__((vector_size(16)));
    static_assert(count <= 4);
    const auto place = [&](std::size_t i) {
        return std::bit_cast<int>(projected.samples[corners[std::min(i, count - 1)]]);
    };
    // Columns and rows by turns: pairs of corners, then the pairs.
    Short8 least = (Short8)Int4{place(0), place(1), place(2), place(3)}, most;
    const Short8 across = __builtin_shufflevector(least, least, 4, 5, 6, 7, 0, 1, 2, 3);
    most = least > across ? least : across;
    least = least < across ? least : across;
    const Short8 otherLeast = __builtin_shufflevector(least, least, 2, 3, 0, 1, 6, 7, 4, 5);
    const Short8 otherMost = __builtin_shufflevector(most, most, 2, 3, 0, 1, 6, 7, 4, 5);
    least = least < otherLeast ? least : otherLeast;
    most = most > otherMost ? most : otherMost;
    if (least[0] == VertexSample::behind) [[unlikely]]
        return boxOfCutCorners(corners, projected, view);
    return {least[0], least[1], most[0], most[1]};
}

/// Finds the tiles of a grid by multiplications: divisions take long.
class TileFinder {
public:
    explicit TileFinder(const TileGrid& grid)
        : columns_(grid.columns()),
          perSample_(((std::uint64_t(1) << shift) + static_cast<std::uint64_t>(grid.side) - 1) /
                     static_cast<std::uint64_t>(grid.side))
    {
    }
    /// The row or column of tiles that a row or column of samples, from 0 to 2^15, is in; of tiles with at most 255
    /// samples a side.
    int tileOf(int sample) const noexcept
    {
        return static_cast<int>(static_cast<std::uint64_t>(sample) * perSample_ >> shift);
    }
    std::size_t numberOf(int row, int column) const noexcept
    {
        const int number = row * columns_ + column;
        return static_cast<std::size_t>(number);
    }

private:
    /// The quotient is rounded up by less than a part in 2^16 of a tile.
    static constexpr int shift = 32;
    int columns_;
    std::uint64_t perSample_;
};

/// Calls visit(row, column) for the tiles that share samples with a box that is not empty.
template <class Visit> void forEachTileOf(const SampleRectangle& box, const TileFinder& tiles, Visit&& visit)
{
    const int lastColumn = tiles.tileOf(box.right - 1);
    const int lastRow = tiles.tileOf(box.bottom - 1);
    for (int row = tiles.tileOf(box.top); row <= lastRow; ++row)
        for (int column = tiles.tileOf(box.left); column <= lastColumn; ++column)
            visit(row, column);
}

/// Samples are drawn in blocks of this shape, the lanes of a vector.
inline constexpr int blockWidth = 4;
inline constexpr int blockHeight = 2;

/// A cell in a tile, and the blocks of the tile that it may cover: columns [left, right), rows [top, bottom).
struct BinnedCell {
    std::uint32_t cell;
    std::uint8_t left, top, right, bottom;
};

/// What each tile may show, front to back.
struct CellBins {
    std::vector<std::uint64_t> first; ///< for each tile the place of its first cell, and after the last tile the end
    Buffer<BinnedCell> cells;

    std::span<const BinnedCell> cellsOf(std::size_t tile) const noexcept
    {
        return std::span(cells).subspan(first[tile], first[tile + 1] - first[tile]);
    }
};

/// Deals the cells of `order` that are visible by class to the tiles whose samples their boxes hold. The grid's tiles
/// have at most 255 blocks a side. O(cells + entries), on all threads of the current arena, the same result with any
/// number. Incomplete if cancelled. May throw std::bad_alloc.
CellBins binCells(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::span<const CellClass> classes,
                  std::span<const std::uint32_t> order, const ProjectedVertices& projected, const VolumeView& view,
                  const TileGrid& grid, const Progress& progress);

} // namespace tetra
