// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/annotations/annotation_painter.h"

#include "core/picture/annotations/annotation_layout.h"
#include "core/picture/annotations/placed_text.h"
#include "core/picture/drawing/canvas.h"
#include "core/picture/drawing/vector_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace tetra {
namespace {

constexpr double leastScale = 0.75;
constexpr double chequer = 5;
constexpr double solidPart = 12; ///< of the bar's width: what is left shows the opacity

/// What all parts are painted with.
struct Brush {
    const PixelCanvas& canvas;
    const Fonts& fonts;
    AnnotationInk ink;
    TextStyle text = annotationText;
};

void paintLabel(const Brush& brush, const PlacedText& label, TextAlignment alignment = TextAlignment::Left)
{
    paintPlacedText(brush.canvas, brush.fonts, label.text, label.place, brush.ink, alignment, brush.text);
}

void paintLine(const Brush& brush, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const PixelInk& ink,
               double width)
{
    strokeLine(brush.canvas, from, to, width + 2, brush.ink.rim);
    strokeLine(brush.canvas, from, to, width, ink);
}

void paintChequers(const PixelCanvas& canvas, const Rectangle& place)
{
    fill(canvas, place, {240, 240, 240});
    for (int row = 0; row * chequer < place.height; ++row)
        for (int column = row % 2; column * chequer < place.width; column += 2) {
            const double x = column * chequer, y = row * chequer;
            fill(canvas,
                 {place.left + x, place.top + y, std::min(chequer, place.width - x),
                  std::min(chequer, place.height - y)},
                 {176, 176, 176});
        }
}

PixelInk inkOf(const TransferSample& sample, double opacity)
{
    return inkOf(Colour{static_cast<float>(sample.colour[0]), static_cast<float>(sample.colour[1]),
                        static_cast<float>(sample.colour[2])},
                 opacity);
}

/// What the bar shows at a share of its height from below: the colour alone, and as opaque as it is.
std::pair<PixelInk, PixelInk> barInks(const TransferFunction& transfer, const BarAxis& axis, double share)
{
    const TransferSample sample = evaluate(transfer, axis.valueAt(share));
    return {inkOf(sample, 1), inkOf(sample, -std::expm1(-sample.extinction * transfer.unitDistance))};
}

/// Columns of colours that change without a step: rows beside each other would show seams where they meet.
void drawTransfer(std::vector<DrawnShape>& drawing, const TransferFunction& transfer, const BarAxis& axis,
                  const Rectangle& colours, const Rectangle& opacities)
{
    constexpr int rows = 512;
    ColourColumn left{colours, {}}, right{opacities, {}};
    for (int row = 0; row < rows; ++row) {
        const auto [solid, opaque] = barInks(transfer, axis, 1 - (row + 0.5) / rows);
        left.rows.push_back(solid);
        right.rows.push_back(opaque);
    }
    drawing.push_back(std::move(left));
    drawing.push_back(std::move(right));
}

/// Left the colours alone, right as opaque as they are: a colour of little opacity could not be told otherwise. Each
/// row of pixels has the colour of its middle.
void paintTransfer(const PixelCanvas& canvas, const TransferFunction& transfer, const BarAxis& axis,
                   const Rectangle& bar)
{
    const double solid = bar.left + solidPart, scale = canvas.scale();
    const Rectangle opacities{solid, bar.top, bar.right() - solid, bar.height};
    paintChequers(canvas, opacities);
    if (canvas.drawing() != nullptr)
        return drawTransfer(*canvas.drawing(), transfer, axis, {bar.left, bar.top, solidPart, bar.height}, opacities);
    const double last = std::min(bar.bottom() * scale, double(canvas.pixels().height));
    for (double row = std::floor(std::max(0.0, bar.top * scale)); row < last; ++row) {
        const double top = std::max(bar.top, row / scale), bottom = std::min(bar.bottom(), (row + 1) / scale);
        const auto [colour, opaque] = barInks(transfer, axis, (bar.bottom() - (top + bottom) / 2) / bar.height);
        fill(canvas, Rectangle{bar.left, top, solidPart, bottom - top}, colour);
        fill(canvas, Rectangle{solid, top, opacities.width, bottom - top}, opaque);
    }
}

/// A line across the bar and a pointer at its left, in the surface's colour.
void paintIsovalue(const Brush& brush, const Isovalue& isovalue, const AxisMark& mark, const Rectangle& bar)
{
    const PixelInk colour = inkOf(Colour{isovalue.red, isovalue.green, isovalue.blue});
    const PixelInk around = brush.ink.dark ? PixelInk{0, 0, 0} : PixelInk{255, 255, 255};
    const double y = mark.position, tip = bar.left - 1;
    strokeLine(brush.canvas, {bar.left + 1, y}, {bar.right() - 1, y}, 4, around, LineEnd::Square);
    strokeLine(brush.canvas, {bar.left, y}, {bar.right(), y}, 2, colour, LineEnd::Square);
    const std::array<Eigen::Vector2d, 3> corners{{{tip, y}, {tip - 7, y - 5}, {tip - 7, y + 5}}};
    const Path pointer = polygonPath(corners);
    fill(brush.canvas, pointer, colour);
    stroke(brush.canvas, pointer, 1, brush.ink.line);
}

/// The colours, or the ground for the marks of surfaces, in a frame.
void paintBar(const Brush& brush, const AnnotationContent& content, const ColourBarLayout& layout)
{
    if (content.transfer) {
        paintTransfer(brush.canvas, *content.transfer, layout.axis, layout.bar);
    } else {
        PixelInk ground = brush.ink.line;
        ground.alpha = 31; // an eighth
        fill(brush.canvas, layout.bar, brush.ink.rim);
        fill(brush.canvas, layout.bar, ground);
    }
    stroke(brush.canvas, rectanglePath(layout.bar.grown(1)), 3, brush.ink.rim);
    stroke(brush.canvas, rectanglePath(layout.bar), 1, brush.ink.line);
}

void paintColourBar(const Brush& brush, const AnnotationContent& content, const ColourBarLayout& layout)
{
    paintBar(brush, content, layout);
    for (const AxisMark& tick : layout.ticks) {
        const double right = layout.bar.right();
        paintLine(brush, {right, tick.position}, {right + 5, tick.position}, brush.ink.line, 1);
        paintLabel(brush, tick.label);
    }
    for (std::size_t i = 0; i < layout.isovalues.size(); ++i) {
        if (layout.isovalues[i].beyond)
            continue;
        paintIsovalue(brush, (*content.isovalues)[i], layout.isovalues[i], layout.bar);
        paintLabel(brush, layout.isovalues[i].label);
    }
    paintLabel(brush, layout.field);
}

/// Of the axis of this number, told apart by brightness, too.
PixelInk axisInk(std::size_t axis, bool dark)
{
    constexpr std::array<PixelInk, 3> onLight{{{196, 60, 20}, {0, 128, 84}, {0, 92, 184}}};
    constexpr std::array<PixelInk, 3> onDark{{{255, 138, 92}, {72, 214, 160}, {112, 182, 255}}};
    return dark ? onDark[axis] : onLight[axis];
}

void paintArrow(const Brush& brush, const Eigen::Vector2d& origin, const Eigen::Vector2d& tip, const PixelInk& ink)
{
    const Eigen::Vector2d end = origin + tip;
    paintLine(brush, origin, end, ink, 2);
    const double length = tip.norm();
    if (length < 6)
        return;
    const Eigen::Vector2d along = tip / length, aside(-along.y(), along.x());
    const std::array<Eigen::Vector2d, 3> corners{end + along * 2, end - along * 6 + aside * 3.5,
                                                 end - along * 6 - aside * 3.5};
    fill(brush.canvas, polygonPath(corners), ink);
}

/// The farthest first.
void paintAxes(const Brush& brush, const AxesLayout& layout)
{
    std::array<std::size_t, 3> order{0, 1, 2};
    std::ranges::sort(order, {}, [&](std::size_t axis) { return layout.axes[axis].depth; });
    for (const std::size_t axis : order) {
        Brush coloured = brush;
        coloured.ink.line = axisInk(axis, brush.ink.dark);
        paintArrow(brush, layout.origin, layout.axes[axis].tip, coloured.ink.line);
        paintLabel(coloured, layout.axes[axis].label, TextAlignment::Centre);
    }
}

void paintScaleBar(const Brush& brush, const ScaleBarLayout& layout)
{
    const Eigen::Vector2d half(0, 3.5);
    for (const Eigen::Vector2d& end : {layout.from, layout.to})
        paintLine(brush, end - half, end + half, brush.ink.line, 1.5);
    paintLine(brush, layout.from, layout.to, brush.ink.line, 2);
    paintLabel(brush, layout.label, TextAlignment::Centre);
}

/// Lines first, so that no number is crossed by one.
void paintBoxAxes(const Brush& brush, const std::vector<BoxAxisLayout>& axes)
{
    constexpr double tickLength = 5;
    for (const BoxAxisLayout& axis : axes) {
        paintLine(brush, axis.from, axis.to, brush.ink.line, 1);
        for (const BoxTick& tick : axis.ticks)
            paintLine(brush, tick.place, tick.place + axis.outwards * tickLength, brush.ink.line, 1);
    }
    for (const BoxAxisLayout& axis : axes) {
        for (const BoxTick& tick : axis.ticks)
            paintLabel(brush, tick.label, TextAlignment::Centre);
        Brush coloured = brush;
        coloured.ink.line = axisInk(axis.axis, brush.ink.dark);
        paintLabel(coloured, axis.name, TextAlignment::Centre);
    }
}

void paintLayout(const Brush& brush, const AnnotationContent& content, const AnnotationLayout& layout)
{
    paintBoxAxes(brush, layout.boxAxes);
    if (layout.colourBar)
        paintColourBar(brush, content, *layout.colourBar);
    if (layout.axes)
        paintAxes(brush, *layout.axes);
    if (layout.scaleBar)
        paintScaleBar(brush, *layout.scaleBar);
    if (layout.accuracy)
        paintLabel(brush, *layout.accuracy);
    if (layout.title) {
        Brush bold = brush;
        bold.text = annotationTitle;
        paintLabel(bold, *layout.title);
    }
}

void grow(Path& path, double factor)
{
    for (PathPoint& point : path)
        point.place *= factor;
}

/// Drawings are in units, whatever they are scaled by: those of larger texts become those of the others.
struct Growing {
    double factor;

    void operator()(FilledPath& shape) const { grow(shape.path, factor); }
    void operator()(StrokedPath& shape) const
    {
        grow(shape.path, factor);
        shape.width *= factor;
    }
    void operator()(ColourColumn& shape) const
    {
        const Rectangle& place = shape.place;
        shape.place = {place.left * factor, place.top * factor, place.width * factor, place.height * factor};
    }
    void operator()(WrittenText& shape) const
    {
        shape.rimWidth *= factor;
        for (GlyphRun& run : shape.runs) {
            run.size *= factor;
            for (GlyphRun::Glyph& glyph : run.glyphs)
                glyph.place *= factor;
        }
    }
};

/// In units that are as much larger as the texts are to be.
void paintInOwnUnits(const PixelCanvas& canvas, const Fonts& fonts, const AnnotationContent& content)
{
    const TextStyle text = content.state.boldText ? annotationTitle : annotationText;
    const AnnotationLayout layout = layOutAnnotations(content, canvas.size(), textMeasure(fonts, text));
    paintLayout({canvas, fonts, annotationInk(content.background), text}, content, layout);
}

} // namespace

Status paintAnnotations(const PixelView& picture, const AnnotationContent& content, double scale)
{
    if (std::ranges::none_of(content.state.places, &AnnotationPlace::shown))
        return {};
    return paintAnnotations(PixelCanvas(picture, scale), content);
}

Status paintAnnotations(const PixelCanvas& canvas, const AnnotationContent& content)
{
    if (std::ranges::none_of(content.state.places, &AnnotationPlace::shown))
        return {};
    const auto fonts = content.fonts ? Result(content.fonts) : openFonts();
    if (!fonts)
        return fonts.error();
    const double factor = content.state.textSize / annotationText.size, scale = canvas.scale() * factor;
    if (canvas.drawing() == nullptr) {
        paintInOwnUnits(PixelCanvas(canvas.pixels(), scale), **fonts, content);
        return {};
    }
    VectorDrawing drawing;
    paintInOwnUnits(PixelCanvas(drawing, canvas.pixels().width, canvas.pixels().height, scale), **fonts, content);
    for (DrawnShape& shape : drawing) {
        std::visit(Growing{factor}, shape);
        canvas.drawing()->push_back(std::move(shape));
    }
    return {};
}

double annotationScale(const Eigen::Vector2i& picture, const Eigen::Vector2i& view)
{
    const double shorter = std::max(1, view.minCoeff());
    return std::max(leastScale, picture.minCoeff() / shorter);
}

} // namespace tetra
