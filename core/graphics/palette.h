// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/picture.h"

#include <array>
#include <cstddef>

namespace tetra {

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

} // namespace tetra
