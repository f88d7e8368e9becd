// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ft2build.h>

#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_STROKER_H

#include <memory>
#include <type_traits>
#include <vector>

namespace tetra {

/// FreeType's outlines, in its own units of a 64th of a pixel, x to the right and y down: what canvas and texts share.

inline constexpr double outlineUnits = 64; ///< a pixel

/// An outline that keeps its points, in FreeType's types: since 2.13.3 they are unsigned.
struct KeptOutline {
    using Tag = std::remove_pointer_t<decltype(FT_Outline::tags)>;
    using Index = std::remove_pointer_t<decltype(FT_Outline::contours)>;

    std::vector<FT_Vector> points;
    std::vector<Tag> tags;
    std::vector<Index> ends; ///< of its contours

    /// Valid until this changes.
    FT_Outline view() noexcept;
};

/// What may be painted of a picture: [0, width) by [0, height).
struct CoverageBounds {
    int width = 0;
    int height = 0;
};

/// Calls `cover(x, y, length, coverage)` for each piece of a row that the outline winds around, at least in part;
/// coverages go to 255. Rows come in no particular order, and no pixel twice. `cover` must not throw.
template <class Cover>
void rasterise(FT_Library library, FT_Outline outline, const CoverageBounds& bounds, Cover&& cover)
{
    if (outline.n_points <= 0 || bounds.width <= 0 || bounds.height <= 0)
        return;
    outline.flags = FT_OUTLINE_NONE; // nonzero windings
    FT_Raster_Params parameters{};
    parameters.flags = FT_RASTER_FLAG_AA | FT_RASTER_FLAG_DIRECT | FT_RASTER_FLAG_CLIP;
    parameters.clip_box = {0, 0, bounds.width, bounds.height};
    parameters.user = &cover;
    parameters.gray_spans = [](int y, int count, const FT_Span* spans, void* user) {
        auto& given = *static_cast<std::remove_reference_t<Cover>*>(user);
        for (int i = 0; i < count; ++i)
            given(spans[i].x, y, spans[i].len, spans[i].coverage);
    };
    FT_Outline_Render(library, &outline, &parameters);
}

struct StrokerClosing {
    void operator()(FT_Stroker stroker) const noexcept { FT_Stroker_Done(stroker); }
};
using Stroker = std::unique_ptr<FT_StrokerRec_, StrokerClosing>;

/// Null if memory is short.
Stroker strokerOf(FT_Library library, double pixels, FT_Stroker_LineCap cap, FT_Stroker_LineJoin join);

/// The outline of a line along this one; `open`: along a path that does not return to its start. Empty where FreeType
/// finds no outline.
KeptOutline strokeOf(FT_Stroker stroker, FT_Outline outline, bool open);

} // namespace tetra
