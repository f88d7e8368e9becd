// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/cpu/draw_list.h"
#include "core/render/tiles.h"
#include "core/render/view_transform.h"

#include <tan/base.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Which triangles each tile may show, in the order of the draw list.
class TileBins {
public:
    /// O(triangles + entries), on all threads of the current arena. May throw std::bad_alloc.
    TileBins(const DrawList& list, const TileGrid& grid);

    std::span<const std::uint32_t> trianglesOf(std::size_t tile) const noexcept
    {
        return std::span(triangles_).subspan(first_[tile], first_[tile + 1] - first_[tile]);
    }

private:
    std::vector<std::uint64_t> first_;
    Buffer<std::uint32_t> triangles_;
};

/// The first sample whose centre does not lie before this place, which is in the vertices' steps.
inline int sampleFrom(std::int32_t place) noexcept
{
    return (place + subsampleSteps / 2 - 1) >> subsampleBits;
}

/// The samples whose centres a triangle's bounding box holds, inside `within`; may be empty (right <= left).
inline SampleRectangle samplesUnder(const DrawList& list, const ScreenTriangle& triangle, const SampleRectangle& within)
{
    const ScreenVertex& a = list.vertices[triangle.vertices[0]];
    const ScreenVertex& b = list.vertices[triangle.vertices[1]];
    const ScreenVertex& c = list.vertices[triangle.vertices[2]];
    return {std::max(within.left, sampleFrom(std::min({a.x, b.x, c.x}))),
            std::max(within.top, sampleFrom(std::min({a.y, b.y, c.y}))),
            std::min(within.right, sampleFrom(std::max({a.x, b.x, c.x}) + 1)),
            std::min(within.bottom, sampleFrom(std::max({a.y, b.y, c.y}) + 1))};
}

} // namespace tetra
