// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/drawing/canvas.h"
#include "core/picture/drawing/fonts.h"

#include <Eigen/Core>

#include <string>
#include <string_view>

namespace tetra {

// Texts of one line, UTF-8: shaped as their scripts want it (HarfBuzz), from right to left where they are read so
// (FriBidi), each character by a font that has it. What no font of the system has is a box.

std::string utf8Of(char32_t character);

struct TextStyle {
    double size = 12; ///< of the font's square, in units
    bool bold = false;
    bool operator==(const TextStyle&) const = default;
};

/// In the units of the style. The same however large a picture is, as nothing is rounded to its pixels.
struct TextMetrics {
    double advance = 0; ///< to where a next text would begin
    double ascent = 0;  ///< of the family's own font: from the baseline up ...
    double descent = 0; ///< ... and down, both positive

    double height() const noexcept { return ascent + descent; }
};

/// Any thread. O(characters).
TextMetrics measured(const Fonts& fonts, std::string_view text, const TextStyle& style);

/// A rim around letters: a line along their outlines, under them.
struct TextRim {
    double width = 0; ///< half of which is outside
    PixelInk ink{};
};

/// `baseline`: where the text begins at its left. Letters stand on whole rows of pixels, so that they are sharp; to the
/// sides they are where they belong. Any thread.
void paintText(const PixelCanvas& canvas, const Fonts& fonts, std::string_view text, const TextStyle& style,
               const Eigen::Vector2d& baseline, const PixelInk& ink, const TextRim& rim);

} // namespace tetra
