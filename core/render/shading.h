// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"

#include <tan/mesh.h>

#include <algorithm>

namespace tetra {

/// A light far away that moves with the camera.
struct CameraLight {
    float right, up, back; ///< where it comes from, of length 1: to the right, up, and from behind the camera
    float strength;
};

/// The light on surfaces and volumes, the same in both back ends: one in the eye, a key light from above on the left
/// that makes relief, a fill light in the shadows that it leaves, and a rim light from behind that parts what is near
/// from what is far. A surface shows the side towards the eye; edge-on, where rounding decides which that is, it has
/// the mean of both, so that nothing flickers along outlines. With n the normal of that side, c its cosine with the
/// direction to the eye and s = min(1, (1 + c / twoSided) / 2), a colour channel becomes
///     min(1, channel * (ambient + headlight c + sum of strength (s max(0, n . light) + (1 - s) max(0, -n . light)))
///            + strength max(0, n . highlight)^32),
/// the highlight that of the key light, halfway between it and the view's axis. Lighting and blending act on the
/// sRGB-coded channels, not on linear light, as VTK and ParaView do: a colour map looks here as it does there.
struct Shading {
    static constexpr float ambient = 0.08f;
    static constexpr float headlight = 0.52f;
    static constexpr float twoSided = 0.25f;
    static constexpr CameraLight lights[] = {
        {-96.0f / 169, 72.0f / 169, 119.0f / 169, 0.45f}, // key
        {0.8f, -0.36f, 0.48f, 0.1f},                      // fill
        {0.36f, 0.8f, -0.48f, 0.1f},                      // rim
    };
    static constexpr CameraLight highlight = {-4.0f / 13, 3.0f / 13, 12.0f / 13, 0.18f};
};

/// What becomes of a colour: times the factor, and the highlight added.
template <class Number> struct Falling {
    Number factor, highlight;
};

/// The cosine of a normal with a light, of lanes or of one number.
template <class Number>
TETRA_SIMD_INLINE Number cosineWith(const CameraLight& light, Number right, Number up, Number back)
{
    return light.right * right + light.up * up + light.back * back;
}

/// The light on a normal of length 1, in the camera's axes as lights are, towards the eye, and its cosine with the
/// direction to the eye. For use inside functions compiled for several instruction sets.
template <class Number> TETRA_SIMD_INLINE Falling<Number> lightOn(Number right, Number up, Number back, Number cosine)
{
    const Number ones = Number{} + 1.0f;
    const Number share = 0.5f + cosine * (0.5f / Shading::twoSided);
    const Number front = share < ones ? share : ones;
    Number factor = Shading::ambient + Shading::headlight * cosine;
    for (const CameraLight& light : Shading::lights) {
        const Number falling = cosineWith(light, right, up, back);
        factor += light.strength * falling * (falling > 0 ? front : front - ones);
    }
    const Number highest = cosineWith(Shading::highlight, right, up, back);
    Number power = highest > 0 ? highest : Number{};
    for (int doubled = 0; doubled < 5; ++doubled)
        power *= power;
    return {factor, Shading::highlight.strength * power};
}

inline Colour shaded(const Colour& colour, const Falling<float>& light)
{
    const auto channel = [&light](float of) { return std::min(1.0f, of * light.factor + light.highlight); };
    return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

} // namespace tetra
