// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/shading.h"
#include "core/graphics/volume/slab_shading.h"

namespace tetra {

/// What the rays of several lanes gather in a cell. For use inside functions compiled for several instruction sets.

/// Rays that may pass a cell.
template <class Lanes> struct CellRays {
    Lanes front, back, slope; ///< of CellSetup
    Lanes ray;                ///< of SampleBlock
    Lanes enter, leave;       ///< w where they come in and go out
};

template <bool perspective, class Lanes> TETRA_SIMD_INLINE void
shade(CellRays<Lanes>& rays, const CellSetup& cell, const ScaledSegment* segments, Gathered<Lanes>& gathered)
{
    const Lanes ones = Lanes{} + 1.0f;
    const Lanes front = rays.front > rays.back ? rays.front : ones;
    const Lanes back = rays.front > rays.back ? rays.back : ones;
    Lanes valueIn, valueOut;
    if constexpr (perspective) {
        const Lanes both = 1.0f / (front * back);
        rays.enter = back * both;
        rays.leave = front * both;
        valueIn = rays.slope * rays.enter + cell.constant;
        valueOut = rays.slope * rays.leave + cell.constant;
    } else {
        rays.enter = -front;
        rays.leave = -back;
        valueIn = rays.slope + cell.constant * front;
        valueOut = rays.slope + cell.constant * back;
    }
    const Lanes length = (rays.leave - rays.enter) * rays.ray;
    if (cell.simple)
        addSlab(gathered, segments[cell.firstSegment], cell.thickness, valueIn, valueOut, length);
    else
        addSlices(gathered, segments, cell, valueIn, valueOut, length);
}

/// Lights what a cell added, as a surface across the gradient would be lit (shading.h). The cosine between the gradient
/// and a ray is the value's change for one unit of w, over that for one unit of length along the gradient and the ray's
/// length for one unit of w.
template <bool perspective, class Lanes> TETRA_SIMD_INLINE void
relight(Gathered<Lanes>& gathered, const Gathered<Lanes>& before, const CellRays<Lanes>& rays, const CellSetup& cell)
{
    const Lanes ones = Lanes{} + 1.0f;
    Lanes change = Lanes{} + cell.constant;
    if constexpr (perspective)
        change = rays.slope;
    const Lanes cosine = smaller(larger(change, -change) * cell.perGradient / rays.ray, ones);
    const Lanes factor = Shading::ambient + Shading::diffuse * cosine;
    Lanes power = cosine * cosine;
    for (int doubled = 0; doubled < 4; ++doubled)
        power *= power;
    const Lanes opacity = before.light - gathered.light;
    const Lanes specular = Shading::specular * power * opacity;
    gathered.red = before.red + smaller((gathered.red - before.red) * factor + specular, opacity);
    gathered.green = before.green + smaller((gathered.green - before.green) * factor + specular, opacity);
    gathered.blue = before.blue + smaller((gathered.blue - before.blue) * factor + specular, opacity);
}

} // namespace tetra
