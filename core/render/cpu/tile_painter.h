// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/cpu/draw_list.h"
#include "core/render/cpu/tile_bins.h"
#include "core/render/tiles.h"
#include "core/render/view_transform.h"
#include "core/render/volume/clip_bounds.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

/// One side of a triangle as an affine function of the sample, positive inside.
struct TriangleSide {
    std::int64_t value = 0; ///< at the first sample
    std::int64_t perX = 0;
    std::int64_t perY = 0;
    std::int64_t bias = 0; ///< 0 if samples exactly on the side belong to the triangle, else -1

    /// Directed from `a` to `b`; `x` and `y` in the vertices' steps. A sample on the side belongs to the triangle that
    /// it would belong to after an infinitely small shift to the right and a still smaller one down: of the triangles
    /// that share the side, or a corner, exactly one.
    TriangleSide(const ScreenVertex& a, const ScreenVertex& b, std::int64_t x, std::int64_t y)
    {
        const std::int64_t dx = std::int64_t(b.x) - a.x;
        const std::int64_t dy = std::int64_t(b.y) - a.y;
        value = dx * (y - a.y) - dy * (x - a.x);
        perX = -dy * subsampleSteps;
        perY = dx * subsampleSteps;
        bias = dy < 0 || (dy == 0 && dx > 0) ? 0 : -1;
    }
};

/// Calls visit(x, y, b, c) for each sample of `within` that the triangle covers; b and c are the barycentric weights of
/// its second and third corner in the picture. Either orientation; a triangle without area covers nothing. Exact for
/// coordinates up to 2^30.
template <class Visit> void rasterizeTriangle(const DrawList& list, const ScreenTriangle& triangle,
                                              const SampleRectangle& within, Visit&& visit)
{
    const SampleRectangle box = samplesUnder(list, triangle, within);
    if (box.width() <= 0 || box.height() <= 0)
        return;
    const ScreenVertex& a = list.vertices[triangle.vertices[0]];
    const ScreenVertex& b = list.vertices[triangle.vertices[1]];
    const ScreenVertex& c = list.vertices[triangle.vertices[2]];
    const std::int64_t area =
        (std::int64_t(b.x) - a.x) * (std::int64_t(c.y) - a.y) - (std::int64_t(b.y) - a.y) * (std::int64_t(c.x) - a.x);
    if (area == 0)
        return;
    const std::int64_t x0 = std::int64_t(box.left) * subsampleSteps + subsampleSteps / 2;
    const std::int64_t y0 = std::int64_t(box.top) * subsampleSteps + subsampleSteps / 2;
    // The side opposite to each corner, all turned so that inside is positive.
    TriangleSide sideA = area > 0 ? TriangleSide(b, c, x0, y0) : TriangleSide(c, b, x0, y0);
    TriangleSide sideB = area > 0 ? TriangleSide(c, a, x0, y0) : TriangleSide(a, c, x0, y0);
    TriangleSide sideC = area > 0 ? TriangleSide(a, b, x0, y0) : TriangleSide(b, a, x0, y0);
    const float scale = 1.0f / static_cast<float>(area > 0 ? area : -area);

    for (int y = box.top; y < box.bottom; ++y) {
        std::int64_t inA = sideA.value + sideA.bias;
        std::int64_t inB = sideB.value + sideB.bias;
        std::int64_t inC = sideC.value + sideC.bias;
        for (int x = box.left; x < box.right; ++x) {
            if ((inA | inB | inC) >= 0)
                visit(x, y, static_cast<float>(inB - sideB.bias) * scale, static_cast<float>(inC - sideC.bias) * scale);
            inA += sideA.perX;
            inB += sideB.perX;
            inC += sideC.perX;
        }
        sideA.value += sideA.perY;
        sideB.value += sideB.perY;
        sideC.value += sideC.perY;
    }
}

/// Draws the triangles of one tile: opaque ones into a depth buffer, translucent ones as fragments that are sorted by
/// depth in each sample and blended exactly. Remembers which triangle each sample shows and lights it at the end, so a
/// hidden surface costs no light. Keeps its memory from tile to tile; one object a thread.
class TilePainter {
public:
    /// All must outlive it.
    TilePainter(const DrawList& list, const ViewTransform& transform, const ClipBounds& clips)
        : list_(list), transform_(transform), clips_(clips)
    {
    }

    /// Finds what the samples of the tile show. May throw std::bad_alloc.
    void draw(const SampleRectangle& tile, std::span<const std::uint32_t> triangles);
    /// The samples that what was drawn covers, counted as often as they are covered, but for what opaque triangles
    /// hide.
    std::size_t fragmentCount() const noexcept { return fragmentCount_; }

    /// The colour of each sample of the tile, row by row, over `background`; valid until the next call. May throw
    /// std::bad_alloc.
    std::span<const PremultipliedColour> colours(const PremultipliedColour& background);
    /// For each sample q (ViewTransform) where half of the light from behind is gone; `neverHalf` where it never is.
    /// Made by colours().
    std::span<const float> halfNearness() const noexcept { return halfNearness_; }
    static constexpr float neverHalf = -1e30f;

    /// The lit fragments, to be blended with something else; valid until the next call. May throw std::bad_alloc.
    const SurfaceFragments& fragments();

private:
    /// A triangle at a sample.
    struct Fragment {
        float nearness;
        std::uint32_t triangle;
        float b; ///< weights of the triangle's second and third corner
        float c;
    };
    struct ListedFragment {
        Fragment fragment;
        std::uint32_t next;
    };
    static constexpr std::uint32_t none = 0xffffffff;

    void clear(const SampleRectangle& tile);
    void drawOpaque(std::uint32_t triangle);
    void collectTranslucent(std::uint32_t triangle);
    bool shows(std::size_t sample, float nearness, bool clipped) const;
    Colour ownColour(const Fragment& fragment) const;
    PremultipliedColour lit(const Fragment& fragment, std::size_t sample) const;
    void sortTranslucent(std::size_t sample);
    /// Calls visit(nearness, colour) for the lit fragments of a sample, front to back, until nothing shines through.
    template <class Visit> void forEachLit(std::size_t sample, Visit&& visit);

    const DrawList& list_;
    const ViewTransform& transform_;
    const ClipBounds& clips_;
    SampleRectangle tile_;
    std::size_t fragmentCount_ = 0;
    std::vector<ClipBounds::Interval> shown_; ///< of each sample's ray, if there are clip planes
    std::vector<Fragment> opaque_;            ///< the nearest opaque fragment of each sample
    std::vector<std::uint32_t> heads_;        ///< of each sample's list of translucent fragments
    std::vector<ListedFragment> listed_;      ///< translucent fragments of all samples
    std::vector<Fragment> sorted_;            ///< of one sample
    std::vector<PremultipliedColour> colours_;
    std::vector<float> halfNearness_;
    SurfaceFragments fragments_;
};

} // namespace tetra
