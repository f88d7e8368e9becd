// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/annotations/annotation_painter.h"

#include "core/view/lens.h"
#include "ui/annotations/annotation_layout.h"

#include <QFontMetricsF>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr int pixelTextSize = 12;
constexpr double rimWidth = 3;
constexpr double rimOpacity = 0.8;
constexpr double least = 0.75; ///< of annotationScale()
constexpr double chequer = 5;
constexpr double lensRim = 2;
constexpr int solidPart = 12; ///< of the bar's width: what is left shows the opacity

struct Ink {
    QColor line;
    QColor rim;
    bool dark = false; ///< the background is
};

Ink inkFor(const Colour& background)
{
    const QColor ground = QColor::fromRgbF(background.red, background.green, background.blue);
    Ink ink;
    ink.dark = 0.3 * background.red + 0.59 * background.green + 0.11 * background.blue < 0.5;
    ink.line = ink.dark ? QColor(238, 238, 238) : QColor(28, 28, 30);
    ink.rim = ground;
    ink.rim.setAlphaF(rimOpacity);
    return ink;
}

QFont fontOf(const AnnotationContent& content)
{
    QFont font = content.font;
    font.setPixelSize(pixelTextSize);
    return font;
}

void paintText(QPainter& painter, const PlacedText& text, const Ink& ink, Qt::Alignment alignment = Qt::AlignLeft)
{
    if (text.text.isEmpty())
        return;
    const QFontMetricsF metrics(painter.font());
    const double left = alignment == Qt::AlignHCenter
                            ? text.place.center().x() - metrics.horizontalAdvance(text.text) / 2
                            : text.place.left();
    const QPointF baseline(left, text.place.center().y() + (metrics.ascent() - metrics.descent()) / 2);
    QPainterPath outline;
    outline.addText(baseline, painter.font(), text.text);
    painter.strokePath(outline, QPen(ink.rim, rimWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setPen(ink.line);
    painter.drawText(baseline, text.text);
}

void paintLine(QPainter& painter, const QLineF& line, const QColor& colour, double width, const Ink& ink)
{
    painter.setPen(QPen(ink.rim, width + 2, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(line);
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(line);
}

void paintChequers(QPainter& painter, const QRectF& place)
{
    painter.fillRect(place, QColor(240, 240, 240));
    for (int row = 0; row * chequer < place.height(); ++row)
        for (int column = row % 2; column * chequer < place.width(); column += 2)
            painter.fillRect(QRectF(place.left() + column * chequer, place.top() + row * chequer, chequer, chequer)
                                 .intersected(place),
                             QColor(176, 176, 176));
}

QColor colourOf(const TransferSample& sample, double opacity)
{
    const auto channel = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
    return QColor::fromRgbF(channel(sample.colour[0]), channel(sample.colour[1]), channel(sample.colour[2]),
                            channel(opacity));
}

/// Left the colours alone, right as opaque as they are: a colour of little opacity could not be told otherwise.
void paintTransfer(QPainter& painter, const TransferFunction& transfer, const BarAxis& axis, const QRectF& bar)
{
    const QRectF opacities = bar.adjusted(solidPart, 0, 0, 0);
    paintChequers(painter, opacities);
    const int rows = std::max(1, static_cast<int>(std::ceil(bar.height() * painter.deviceTransform().m22())));
    QImage colours(2, rows, QImage::Format_ARGB32);
    for (int row = 0; row < rows; ++row) {
        const TransferSample sample = evaluate(transfer, axis.valueAt(1 - (row + 0.5) / rows));
        colours.setPixelColor(0, row, colourOf(sample, 1));
        colours.setPixelColor(1, row, colourOf(sample, -std::expm1(-sample.extinction * transfer.unitDistance)));
    }
    painter.drawImage(QRectF(bar.left(), bar.top(), solidPart, bar.height()), colours, QRectF(0, 0, 1, rows));
    painter.drawImage(opacities, colours, QRectF(1, 0, 1, rows));
}

/// A line across the bar and a pointer at its left, in the surface's colour.
void paintIsovalue(QPainter& painter, const Isovalue& isovalue, const AxisMark& mark, const QRectF& bar, const Ink& ink)
{
    const QColor colour = QColor::fromRgbF(isovalue.red, isovalue.green, isovalue.blue);
    painter.setPen(QPen(ink.dark ? Qt::black : Qt::white, 4));
    painter.drawLine(QPointF(bar.left() + 1, mark.position), QPointF(bar.right() - 1, mark.position));
    painter.setPen(QPen(colour, 2));
    painter.drawLine(QPointF(bar.left(), mark.position), QPointF(bar.right(), mark.position));
    painter.setPen(QPen(ink.line, 1));
    painter.setBrush(colour);
    const double x = bar.left() - 1;
    painter.drawPolygon(
        QPolygonF{QPointF(x, mark.position), QPointF(x - 7, mark.position - 5), QPointF(x - 7, mark.position + 5)});
    painter.setBrush(Qt::NoBrush);
}

void paintColourBar(QPainter& painter, const AnnotationContent& content, const ColourBarLayout& layout, const Ink& ink)
{
    if (content.transfer) {
        paintTransfer(painter, *content.transfer, layout.axis, layout.bar);
    } else {
        QColor ground = ink.line;
        ground.setAlphaF(0.12F);
        painter.fillRect(layout.bar, ink.rim);
        painter.fillRect(layout.bar, ground);
    }
    painter.setPen(QPen(ink.rim, 3));
    painter.drawRect(layout.bar.adjusted(-1, -1, 1, 1));
    painter.setPen(QPen(ink.line, 1));
    painter.drawRect(layout.bar);
    for (const AxisMark& tick : layout.ticks) {
        const double right = layout.bar.right();
        paintLine(painter, QLineF(right, tick.position, right + 5, tick.position), ink.line, 1, ink);
        paintText(painter, tick.label, ink);
    }
    for (std::size_t i = 0; i < layout.isovalues.size(); ++i) {
        if (layout.isovalues[i].beyond)
            continue;
        paintIsovalue(painter, (*content.isovalues)[i], layout.isovalues[i], layout.bar, ink);
        paintText(painter, layout.isovalues[i].label, ink);
    }
    paintText(painter, layout.field, ink);
}

/// Of the axis of this number, told apart by brightness, too.
QColor axisColour(std::size_t axis, const Ink& ink)
{
    static const std::array light{QColor(196, 60, 20), QColor(0, 128, 84), QColor(0, 92, 184)};
    static const std::array dark{QColor(255, 138, 92), QColor(72, 214, 160), QColor(112, 182, 255)};
    return ink.dark ? dark[axis] : light[axis];
}

void paintArrow(QPainter& painter, const QPointF& origin, const QPointF& tip, const QColor& colour, const Ink& ink)
{
    paintLine(painter, QLineF(origin, origin + tip), colour, 2, ink);
    const double length = std::hypot(tip.x(), tip.y());
    if (length < 6)
        return;
    const QPointF along = tip / length;
    const QPointF aside(-along.y(), along.x());
    const QPointF end = origin + tip;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF{end + along * 2, end - along * 6 + aside * 3.5, end - along * 6 - aside * 3.5});
    painter.setBrush(Qt::NoBrush);
}

/// The farthest first.
void paintAxes(QPainter& painter, const AxesLayout& layout, const Ink& ink)
{
    std::array<std::size_t, 3> order{0, 1, 2};
    std::ranges::sort(order, {}, [&](std::size_t axis) { return layout.axes[axis].depth; });
    for (const std::size_t axis : order) {
        const QColor colour = axisColour(axis, ink);
        paintArrow(painter, layout.origin, layout.axes[axis].tip, colour, ink);
        paintText(painter, layout.axes[axis].label, {colour, ink.rim, ink.dark}, Qt::AlignHCenter);
    }
}

void paintScaleBar(QPainter& painter, const ScaleBarLayout& layout, const Ink& ink)
{
    for (const QPointF& end : {layout.bar.p1(), layout.bar.p2()})
        paintLine(painter, QLineF(end - QPointF(0, 3.5), end + QPointF(0, 3.5)), ink.line, 1.5, ink);
    paintLine(painter, layout.bar, ink.line, 2, ink);
    paintText(painter, layout.label, ink, Qt::AlignHCenter);
}

} // namespace

void paintAnnotations(QPainter& painter, const AnnotationContent& content, QSizeF picture)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(fontOf(content));
    QFont bold = painter.font();
    bold.setBold(true);
    const QFontMetricsF metrics(painter.font()), boldMetrics(bold);
    const TextMeasure measure{[&](const QString& text) { return metrics.horizontalAdvance(text); },
                              [&](const QString& text) { return boldMetrics.horizontalAdvance(text); },
                              metrics.height()};
    const AnnotationLayout layout = layOutAnnotations(content, picture, measure);
    const Ink ink = inkFor(content.background);
    if (layout.colourBar)
        paintColourBar(painter, content, *layout.colourBar, ink);
    if (layout.axes)
        paintAxes(painter, *layout.axes, ink);
    if (layout.scaleBar)
        paintScaleBar(painter, *layout.scaleBar, ink);
    if (layout.accuracy)
        paintText(painter, *layout.accuracy, ink);
    if (layout.title) {
        painter.setFont(bold);
        paintText(painter, *layout.title, ink);
    }
    painter.restore();
}

void paintAnnotations(QImage& image, const AnnotationContent& content, double scale)
{
    const QImage::Format format = image.format();
    // Painting translucent ink over straight alpha is slow and coarse.
    image = image.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    {
        QPainter painter(&image);
        painter.scale(scale, scale);
        paintAnnotations(painter, content, QSizeF(image.size()) / scale);
    }
    image = image.convertToFormat(format);
}

namespace {

QPainterPath outlineOf(const DrawnLens& lens, double within)
{
    const PixelRectangle& square = lens.place.square;
    const QRectF all =
        QRectF(square.left, square.top, square.width, square.height).adjusted(within, within, -within, -within);
    QPainterPath path;
    if (lens.shape == LensState::Shape::Circle)
        path.addEllipse(all);
    else
        path.addRect(all);
    return path;
}

} // namespace

void paintLens(QPainter& painter, const DrawnLens& lens, const Colour& background, double scale)
{
    const LensPicture& place = lens.place;
    const Ink ink = inkFor(background);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QPainterPath path = outlineOf(lens, lensRim * scale / 2);
    if (!lens.content.isNull()) {
        painter.setClipPath(path, Qt::IntersectClip);
        painter.setCompositionMode(QPainter::CompositionMode_Source);
        painter.drawImage(
            QRectF(place.square.left + place.left, place.square.top + place.top, place.part.width, place.part.height),
            lens.content);
        painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
        painter.setClipping(false);
    }
    painter.setPen(QPen(ink.rim, (lensRim + 2) * scale));
    painter.drawPath(path);
    painter.setPen(QPen(ink.line, lensRim * scale));
    painter.drawPath(path);
    QFont font;
    font.setPixelSize(pixelTextSize);
    painter.setFont(font);
    const QString text = QLocale().toString(place.magnification, 'g', 3) + QChar(0xd7);
    const double height = QFontMetricsF(font).height();
    painter.translate(place.square.left + place.square.width / 2.0, place.square.top + place.square.height);
    painter.scale(scale, scale);
    paintText(painter, {text, QRectF(-height, -1.25 * height, 2 * height, height)}, ink, Qt::AlignHCenter);
    painter.restore();
}

double annotationScale(QSize picture, QSize view)
{
    const double shorter = std::max(1, std::min(view.width(), view.height()));
    return std::max(least, std::min(picture.width(), picture.height()) / shorter);
}

} // namespace tetra
