// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// A colour in sRGB, each channel in [0, 1].
struct Colour {
    float red = 0;
    float green = 0;
    float blue = 0;
};

/// A finished picture: rows from top to bottom, 8-bit sRGB with straight (not premultiplied) alpha.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::array<std::uint8_t, 4>> pixels;
};

} // namespace tetra
