// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// A colour in sRGB, each channel in [0, 1].
struct Colour {
    float red = 0;
    float green = 0;
    float blue = 0;
    bool operator==(const Colour&) const = default;
};

/// A finished picture: rows from top to bottom, 8-bit sRGB with straight (not premultiplied) alpha.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::array<std::uint8_t, 4>> pixels;
    /// If wanted: for each pixel the distance from the eye along the view's axis, in the units of the dataset, at which
    /// half of the light from behind is gone; infinity where it never is.
    std::vector<float> depth{};
};

/// The colour of the index-th of several things to be told apart, also by people who do not see red or green as others
/// do: the palette of Okabe and Ito (Color Universal Design, 2008) without black, repeated after seven.
constexpr Colour distinctColour(std::size_t index)
{
    constexpr std::array<Colour, 7> okabeIto = {{
        {230 / 255.0f, 159 / 255.0f, 0 / 255.0f},   // orange
        {86 / 255.0f, 180 / 255.0f, 233 / 255.0f},  // sky blue
        {0 / 255.0f, 158 / 255.0f, 115 / 255.0f},   // bluish green
        {213 / 255.0f, 94 / 255.0f, 0 / 255.0f},    // vermilion
        {0 / 255.0f, 114 / 255.0f, 178 / 255.0f},   // blue
        {204 / 255.0f, 121 / 255.0f, 167 / 255.0f}, // reddish purple
        {240 / 255.0f, 228 / 255.0f, 66 / 255.0f},  // yellow
    }};
    return okabeIto[index % okabeIto.size()];
}

/// Makes pixels of a rectangle of samples: each the mean of samplesPerAxis squared samples, from premultiplied to
/// straight alpha, rounded to 8 bits. `samples` has rows of `rowLength`, its upper left pixel is (left, top) of
/// `picture`; both sides of the rectangle are multiples of samplesPerAxis.
void resolve(std::span<const std::array<float, 4>> samples, int rowLength, int samplesPerAxis, int left, int top,
             Picture& picture);

/// The same for depths of Picture: each pixel gets the least by which at least half of its samples have lost half of
/// their light.
void resolveDepth(std::span<const float> samples, int rowLength, int samplesPerAxis, int left, int top,
                  Picture& picture);

} // namespace tetra
