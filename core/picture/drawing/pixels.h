// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// The pixels of a picture, to be painted over: rows from top to bottom, one behind the other, 8-bit sRGB with straight
/// alpha, as those of tetra::Picture. They are somebody else's, and stay where they are as long as this is used.
struct PixelView {
    std::span<std::array<std::uint8_t, 4>> pixels{}; ///< width times height
    int width = 0;
    int height = 0;

    std::array<std::uint8_t, 4>* row(int y) const noexcept
    {
        return pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    }
};

inline PixelView pixelsOf(Picture& picture) noexcept
{
    return {picture.pixels, picture.width, picture.height};
}

} // namespace tetra
