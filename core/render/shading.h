// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/mesh.h>

#include <algorithm>

namespace tetra {

/// The light on a surface, the same in both back ends: a headlight in the eye, equal on both sides. With c the cosine
/// between the normal and the direction to the eye, a colour channel becomes
///     min(1, channel * (ambient + diffuse * |c|) + specular * |c|^32).
/// Lighting and blending act on the sRGB-coded channels, not on linear light, as VTK and ParaView do: a colour map
/// looks here as it does there.
struct Shading {
    static constexpr float ambient = 0.25f;
    static constexpr float diffuse = 0.75f;
    static constexpr float specular = 0.15f;
};

/// The colour of a lit surface, from the absolute cosine and its square, which the caller has anyway.
inline Colour shaded(const Colour& colour, float cosine, float squaredCosine)
{
    const float power4 = squaredCosine * squaredCosine;
    const float power8 = power4 * power4;
    const float power16 = power8 * power8;
    const float specular = Shading::specular * power16 * power16;
    const float factor = Shading::ambient + Shading::diffuse * cosine;
    return {std::min(1.0f, colour.red * factor + specular), std::min(1.0f, colour.green * factor + specular),
            std::min(1.0f, colour.blue * factor + specular)};
}

} // namespace tetra
