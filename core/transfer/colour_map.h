// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/transfer.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

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

/// A colour space by one of the names that ParaView's files have for it. None if it is not known here.
inline std::optional<ColourSpace> colourSpaceNamed(std::string_view name, bool wrapped)
{
    if (name == "RGB")
        return ColourSpace::Rgb;
    if (name == "HSV")
        return wrapped ? ColourSpace::HsvWrapped : ColourSpace::Hsv;
    if (name == "Wrapped" || name == "WrappedHSV")
        return ColourSpace::HsvWrapped;
    if (name == "Lab" || name == "CIELAB")
        return ColourSpace::Lab;
    if (name == "Diverging")
        return ColourSpace::Diverging;
    if (name == "Step")
        return ColourSpace::Step;
    return std::nullopt;
}

/// As ParaView 5 calls it; whether a hue is wrapped is said beside.
inline std::string_view colourSpaceName(ColourSpace space)
{
    switch (space) {
    case ColourSpace::Rgb: return "RGB";
    case ColourSpace::Hsv:
    case ColourSpace::HsvWrapped: return "HSV";
    case ColourSpace::Lab: return "Lab";
    case ColourSpace::Diverging: return "Diverging";
    case ColourSpace::Step: return "Step";
    }
    return "RGB";
}

} // namespace tetra
