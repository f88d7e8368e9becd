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

} // namespace tetra
