// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/paraview/colour_space.h"

#include <optional>
#include <string_view>

namespace tetra {

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
