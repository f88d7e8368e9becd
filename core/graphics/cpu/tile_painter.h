// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/cpu/draw_list.h"
#include "core/graphics/cpu/tile_bins.h"
#include "core/graphics/view_transform.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Colour times opacity, and opacity.
using PremultipliedColour = std::array<float, 4>;

/// Draws the triangles of one tile: opaque ones into a depth buffer, translucent ones as fragments that are sorted by
/// depth in each sample and blended exactly. Remembers which triangle each sample shows and lights it at the end, so a
/// hidden surface costs no light. Keeps its memory from tile to tile; one object a thread.
class TilePainter {
public:
    TilePainter(const DrawList& list, const ViewTransform& transform) : list_(list), transform_(transform) {}

    /// The colour of each sample of the tile, row by row, over `background`; valid until the next call. May throw
    /// std::bad_alloc.
    std::span<const PremultipliedColour> paint(const SampleRectangle& tile, std::span<const std::uint32_t> triangles,
                                               const PremultipliedColour& background);

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
    PremultipliedColour lit(const Fragment& fragment, std::size_t sample) const;
    PremultipliedColour composite(std::size_t sample, const PremultipliedColour& background);

    const DrawList& list_;
    const ViewTransform& transform_;
    SampleRectangle tile_;
    std::vector<Fragment> opaque_;       ///< the nearest opaque fragment of each sample
    std::vector<std::uint32_t> heads_;   ///< of each sample's list of translucent fragments
    std::vector<ListedFragment> listed_; ///< translucent fragments of all samples
    std::vector<Fragment> sorted_;       ///< of one sample
    std::vector<PremultipliedColour> colours_;
};

} // namespace tetra
