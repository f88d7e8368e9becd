// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace tetra {

/// A colour as sRGB, each channel in [0, 1].
using SrgbColour = std::array<double, 3>;

/// How ParaView and VTK go from one colour to the next.
enum class ColourSpace : std::uint8_t {
    Rgb,
    Hsv,        ///< the hue never passes through red
    HsvWrapped, ///< the hue goes the shorter way round
    Lab,        ///< CIELAB of D65
    Diverging,  ///< K. Moreland, "Diverging Color Maps for Scientific Visualization" (2009): white between two hues
    Step        ///< the colour of the next point
};

/// The colour a share `s` in [0, 1] of the way from `from` to `to`, as VTK 9 computes it.
SrgbColour between(const SrgbColour& from, const SrgbColour& to, double s, ColourSpace space);

} // namespace tetra
