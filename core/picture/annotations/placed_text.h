// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_layout.h"
#include "core/picture/drawing/rectangle.h"
#include "core/picture/drawing/text.h"

#include <tan/render.h>

#include <string>

namespace tetra {

/// What annotations and lenses are painted with over a background.
struct AnnotationInk {
    PixelInk line{};
    PixelInk rim{};    ///< translucent, around lines and letters
    bool dark = false; ///< the background is
};

AnnotationInk annotationInk(const Colour& background);

inline constexpr TextStyle annotationText{.size = 12};
inline constexpr TextStyle annotationTitle{.size = 12, .bold = true};

/// For layOutAnnotations(), as long as the fonts are there. The height is a whole number, so that lines of pictures
/// lie on their pixels whatever the font. `style`: of all but titles.
TextMeasure textMeasure(const Fonts& fonts, const TextStyle& style = annotationText);

enum class TextAlignment { Left, Centre };

/// In the middle of the place's height, with a rim, in the ink's colour of lines.
void paintPlacedText(const PixelCanvas& canvas, const Fonts& fonts, const std::string& text, const Rectangle& place,
                     const AnnotationInk& ink, TextAlignment alignment = TextAlignment::Left,
                     const TextStyle& style = annotationText);

} // namespace tetra
