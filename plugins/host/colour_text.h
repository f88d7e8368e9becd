// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/render.h>

#include <string>
#include <string_view>

namespace tetra {

/// Reads "#rgb", "#rrggbb" or one of colourNames(). The error lists them.
Result<Colour> parseColour(std::string_view text);

/// "#rrggbb".
std::string colourText(const Colour& colour);

/// "black, blue, ...": for help and error texts.
std::string colourNames();

} // namespace tetra
