// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/cpu/tile_bins.h"
#include "core/graphics/volume/projected_vertices.h"
#include "core/graphics/volume/volume_view.h"

#include <algorithm>
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
    const VertexSample first = projected.samples[corners[0]];
    SampleRectangle box{first.column, first.row, first.column, first.row};
    for (std::size_t i = 1; i < count; ++i) {
        const VertexSample sample = projected.samples[corners[i]];
        box.left = std::min<int>(box.left, sample.column);
        box.top = std::min<int>(box.top, sample.row);
        box.right = std::max<int>(box.right, sample.column);
        box.bottom = std::max<int>(box.bottom, sample.row);
    }
    if (box.left == VertexSample::behind) [[unlikely]]
        return boxOfCutCorners(corners, projected, view);
    return box;
}

/// Calls visit(row, column) for the tiles that share samples with a box that is not empty.
template <class Visit> void forEachTileOf(const SampleRectangle& box, const TileGrid& grid, Visit&& visit)
{
    const int lastColumn = (box.right - 1) / grid.side;
    const int lastRow = (box.bottom - 1) / grid.side;
    for (int row = box.top / grid.side; row <= lastRow; ++row)
        for (int column = box.left / grid.side; column <= lastColumn; ++column)
            visit(row, column);
}

} // namespace tetra
