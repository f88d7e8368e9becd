// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/drawing/canvas.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace tetra {

/// How a pixel looks of which `coverage` / 255 are covered by ink: "over" of Porter and Duff, for straight alpha.
inline void blend(std::array<std::uint8_t, 4>& pixel, const PixelInk& ink, unsigned coverage) noexcept
{
    const unsigned over = (ink.alpha * coverage + 127) / 255;
    if (over == 0)
        return;
    const unsigned ofInk = 255 * over, ofPixel = pixel[3] * (255 - over), sum = ofInk + ofPixel;
    const std::array<unsigned, 3> colour{ink.red, ink.green, ink.blue};
    for (std::size_t channel = 0; channel < 3; ++channel)
        pixel[channel] =
            static_cast<std::uint8_t>((colour[channel] * ofInk + pixel[channel] * ofPixel + sum / 2) / sum);
    pixel[3] = static_cast<std::uint8_t>((sum + 127) / 255);
}

/// How a pixel looks of which `coverage` / 255 became another one.
inline void mix(std::array<std::uint8_t, 4>& pixel, const std::array<std::uint8_t, 4>& other,
                unsigned coverage) noexcept
{
    const unsigned ofOther = other[3] * coverage, ofPixel = pixel[3] * (255 - coverage), sum = ofOther + ofPixel;
    for (std::size_t channel = 0; channel < 3 && sum > 0; ++channel)
        pixel[channel] =
            static_cast<std::uint8_t>((other[channel] * ofOther + pixel[channel] * ofPixel + sum / 2) / sum);
    pixel[3] = static_cast<std::uint8_t>((sum + 127) / 255);
}

} // namespace tetra
