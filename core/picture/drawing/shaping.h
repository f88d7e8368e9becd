// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/drawing/font_files.h"

#include <string_view>
#include <vector>

namespace tetra {

/// A glyph of a font with the place of its origin, in pixels from where the text begins, y down.
struct PlacedGlyph {
    FontFile* font = nullptr;
    unsigned glyph = 0;
    double x = 0;
    double y = 0;
};

/// From left to right.
struct ShapedText {
    std::vector<PlacedGlyph> glyphs;
    double advance = 0;
};

/// A line of text in letters of so many pixels. The family is the caller's alone meanwhile. O(characters).
ShapedText shaped(FontFamily& family, std::string_view text, double pixels);

} // namespace tetra
