// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/drawing/canvas.h"
#include "core/picture/drawing/rectangle.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace tetra {

// What a canvas keeps instead of painting pixels: lines, shapes and texts, in units from the upper left corner, y down,
// the first at the bottom of the pile.

struct FilledPath {
    Path path{};
    PixelInk ink{};
};

struct StrokedPath {
    Path path{};
    bool closed = true;
    double width = 1;
    PixelInk ink{};
    LineEnd end = LineEnd::Flat;
};

/// A rectangle whose colour changes from above to below: the colours of as many rows of one height, blended from middle
/// to middle.
struct ColourColumn {
    Rectangle place{};
    std::vector<PixelInk> rows{};
};

/// One font of one file, as fontconfig found it.
struct FontSource {
    std::string file{};
    int index = 0;
    std::string variations{}; ///< "wght=700,wdth=75"
    bool thickened = false;   ///< letters are made bold, as the family has no bold font
    bool operator==(const FontSource&) const = default;
};

/// Letters that one font writes in one direction, with the text that they stand for.
struct GlyphRun {
    struct Glyph {
        unsigned id = 0;
        Eigen::Vector2d place{0, 0}; ///< of its origin
    };
    /// Neighbouring characters that only together are neighbouring glyphs.
    struct Cluster {
        int bytes = 0;
        int glyphs = 0;
    };
    FontSource font{};
    double size = 12;
    std::string text{};              ///< in the order in which it is read
    std::vector<Glyph> glyphs{};     ///< from left to right
    std::vector<Cluster> clusters{}; ///< in the order of the text
    bool backward = false;           ///< the text is read from right to left
};

struct WrittenText {
    std::vector<GlyphRun> runs{};
    PixelInk ink{};
    double rimWidth = 0; ///< of a line along the outlines, under the letters; 0: none
    PixelInk rimInk{};
};

using DrawnShape = std::variant<FilledPath, StrokedPath, ColourColumn, WrittenText>;
using VectorDrawing = std::vector<DrawnShape>;

} // namespace tetra
