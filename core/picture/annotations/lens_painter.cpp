// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/annotations/lens_painter.h"

#include "core/picture/annotations/axis_ticks.h"
#include "core/picture/annotations/placed_text.h"
#include "core/picture/drawing/canvas.h"

namespace tetra {
namespace {

constexpr double lensRim = 2;
constexpr int magnificationDigits = 3;

Path outlineOf(const DrawnLens& lens, double within)
{
    const PixelRectangle& square = lens.place.square;
    const Rectangle all =
        Rectangle{double(square.left), double(square.top), double(square.width), double(square.height)}.grown(-within);
    return lens.shape == LensState::Shape::Circle ? ellipsePath(all) : rectanglePath(all);
}

/// Above the lower end of the lens.
void paintMagnification(const PixelView& picture, const LensPicture& place, const AnnotationInk& ink, double scale,
                        const NumberSigns& numbers, const Fonts& fonts)
{
    const PixelCanvas canvas(picture, scale);
    const std::string text = shortNumber(place.magnification, numbers, magnificationDigits) + "×";
    const double height = measured(fonts, text, annotationText).height();
    const double middle = (place.square.left + place.square.width / 2.0) / scale,
                 bottom = (place.square.top + place.square.height) / scale;
    paintPlacedText(canvas, fonts, text, {middle - height, bottom - 1.25 * height, 2 * height, height}, ink,
                    TextAlignment::Centre);
}

} // namespace

Status paintLens(const PixelView& picture, const DrawnLens& lens, const Colour& background, double scale,
                 const LensWriting& writing)
{
    const auto fonts = writing.fonts ? Result(writing.fonts) : openFonts();
    if (!fonts)
        return fonts.error();
    const LensPicture& place = lens.place;
    const AnnotationInk ink = annotationInk(background);
    const PixelCanvas canvas(picture, 1);
    const Path outline = outlineOf(lens, lensRim * scale / 2);
    if (!lens.content.pixels.empty())
        replaceWithin(canvas, outline, lens.content, place.square.left + place.left, place.square.top + place.top);
    stroke(canvas, outline, (lensRim + 2) * scale, ink.rim);
    stroke(canvas, outline, lensRim * scale, ink.line);
    paintMagnification(picture, place, ink, scale, writing.numbers, **fonts);
    return {};
}

} // namespace tetra
