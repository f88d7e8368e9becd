// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/drawing/outlines.h"

#include <cmath>
#include <limits>

namespace tetra {

FT_Outline KeptOutline::view() noexcept
{
    FT_Outline outline{};
    outline.n_points = static_cast<Index>(points.size());
    outline.n_contours = static_cast<Index>(ends.size());
    outline.points = points.data();
    outline.tags = tags.data();
    outline.contours = ends.data();
    return outline;
}

Stroker strokerOf(FT_Library library, double pixels, FT_Stroker_LineCap cap, FT_Stroker_LineJoin join)
{
    FT_Stroker made = nullptr;
    if (FT_Stroker_New(library, &made) != 0)
        return nullptr;
    Stroker stroker(made);
    FT_Stroker_Set(made, std::lround(pixels / 2 * outlineUnits), cap, join, 0);
    return stroker;
}

KeptOutline strokeOf(FT_Stroker stroker, FT_Outline outline, bool open)
{
    FT_UInt points = 0, contours = 0;
    constexpr FT_UInt most = std::numeric_limits<short>::max();
    if (FT_Stroker_ParseOutline(stroker, &outline, open ? 1 : 0) != 0 ||
        FT_Stroker_GetCounts(stroker, &points, &contours) != 0 || points > most || contours > most)
        return {};
    KeptOutline kept;
    kept.points.resize(points);
    kept.tags.resize(points);
    kept.ends.resize(contours);
    FT_Outline target = kept.view();
    target.n_points = target.n_contours = 0; // it is added to what is there
    FT_Stroker_Export(stroker, &target);
    return kept;
}

} // namespace tetra
