// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"

namespace tetra {

/// What several slabs, in each of which extinction and colour are affine along the ray, do to light: `opacity` is
/// 1 - e^-T for the optical depth T, and the light of the slab is colourIn * opacity + (colourOut - colourIn) * weight.
template <class Lanes> struct SlabLight {
    Lanes opacity;
    Lanes weight;
};

/// `depth` is the optical depth T in [0, 1]; `half` is half the length times the extinction's rise, in [-T, T].
///
/// With u from 0 to 1 along the slab the optical depth before u is T u - half u (1 - u), and
///     opacity = T p(T),   weight = integral of u d(1 - e^-depth(u)) = p(T) (T / 2 + half / 6 + X(T, half)).
/// p and X are polynomials fitted on that domain, X with the terms that the series of the integral has; the largest
/// errors are 1e-7 of the opacity and 9e-6 of the weight.
template <class Lanes> TETRA_SIMD_INLINE void slabLight(Lanes depth, Lanes half, SlabLight<Lanes>& light)
{
    const Lanes p =
        1.0f + depth * (-0.4999960023f +
                        depth * (0.1666125576f +
                                 depth * (-0.0414223966f + depth * (0.0078387837f + depth * -0.00091243686f))));
    const Lanes squared = depth * depth;
    const Lanes halfSquared = half * half;
    const Lanes ofDepth = squared * (-0.0833209005f + 0.00133735480f * squared);
    const Lanes ofHalf = halfSquared * (0.0166636361f - 0.00031941871f * squared);
    const Lanes odd = 0.1666666667f - 0.00272286018f * squared + 0.00116581360f * halfSquared;
    light.opacity = depth * p;
    light.weight = p * (0.5f * depth + half * odd + ofDepth + ofHalf);
}

/// The same for optical depths up to `faintDepth`, where shorter series have errors as small.
inline constexpr float faintDepth = 0.125f;

template <class Lanes> TETRA_SIMD_INLINE void faintSlabLight(Lanes depth, Lanes half, SlabLight<Lanes>& light)
{
    const Lanes p = 1.0f + depth * (-0.5f + depth * (1 / 6.0f - (1 / 24.0f) * depth));
    light.opacity = depth * p;
    light.weight = p * (depth * (0.5f - (1 / 12.0f) * depth) + half * (1 / 6.0f + (1 / 60.0f) * half));
}

} // namespace tetra
