// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"
#include "core/graphics/cpu/tile_grid.h"
#include "core/graphics/volume/projected_vertices.h"
#include "core/graphics/volume/volume_view.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

namespace tetra {

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
        return static_cast<std::size_t>(row * columns_ + column);
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

} // namespace tetra
