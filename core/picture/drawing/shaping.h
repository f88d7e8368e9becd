// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/drawing/font_files.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// A glyph of a font with the place of its origin, in pixels from where the text begins, y down.
struct PlacedGlyph {
    FontFile* font = nullptr;
    unsigned glyph = 0;
    double x = 0;
    double y = 0;
    std::size_t character = 0; ///< the first of those that it stands for
};

/// Characters that are written by one font in one direction, and their glyphs: the first and the one behind the last.
struct ShapedRun {
    std::size_t firstCharacter = 0;
    std::size_t endCharacter = 0;
    std::size_t firstGlyph = 0;
    std::size_t endGlyph = 0;
    bool backward = false; ///< from right to left
};

/// From left to right.
struct ShapedText {
    std::u32string characters; ///< in the order in which they are read
    std::vector<ShapedRun> runs;
    std::vector<PlacedGlyph> glyphs;
    double advance = 0;
};

/// A line of text in letters of so many pixels. The family is the caller's alone meanwhile. O(characters).
ShapedText shaped(FontFamily& family, std::string_view text, double pixels);

} // namespace tetra
