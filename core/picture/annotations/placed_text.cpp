// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/annotations/placed_text.h"

#include <cmath>

namespace tetra {
namespace {

constexpr double rimWidth = 3;
constexpr double rimOpacity = 0.8;

} // namespace

AnnotationInk annotationInk(const Colour& background)
{
    AnnotationInk ink;
    ink.dark = 0.3 * background.red + 0.59 * background.green + 0.11 * background.blue < 0.5;
    ink.line = ink.dark ? PixelInk{238, 238, 238} : PixelInk{28, 28, 30};
    ink.rim = inkOf(background, rimOpacity);
    return ink;
}

TextMeasure textMeasure(const Fonts& fonts, const TextStyle& style)
{
    return {[&fonts, style](const std::string& text) { return measured(fonts, text, style).advance; },
            [&fonts](const std::string& text) { return measured(fonts, text, annotationTitle).advance; },
            std::round(measured(fonts, {}, style).height())};
}

void paintPlacedText(const PixelCanvas& canvas, const Fonts& fonts, const std::string& text, const Rectangle& place,
                     const AnnotationInk& ink, TextAlignment alignment, const TextStyle& style)
{
    if (text.empty())
        return;
    const TextMetrics metrics = measured(fonts, text, style);
    const Eigen::Vector2d middle = place.centre();
    const double left = alignment == TextAlignment::Centre ? middle.x() - metrics.advance / 2 : place.left;
    const double baseline = middle.y() + (metrics.ascent - metrics.descent) / 2;
    paintText(canvas, fonts, text, style, {left, baseline}, ink.line, {rimWidth, ink.rim});
}

} // namespace tetra
