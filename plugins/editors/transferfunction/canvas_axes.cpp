// SPDX-License-Identifier: GPL-3.0-or-later
// The axes of the editor's plot, and what stands at its edges.
#include "plugins/editors/transferfunction/canvas_painting.h"
#include "plugins/editors/transferfunction/value_text.h"
#include "plugins/widgets/number_text.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {
namespace {

constexpr double halfHandle = 5;
constexpr double mostDecadesWithMultiples = 8;

void paintOpacities(QPainter& painter, const CanvasScene& scene, const QColor& text)
{
    const TransferPlot& plot = scene.plot;
    const int line = painter.fontMetrics().height();
    double last = plot.area.bottom() + 2 * line;
    for (const double opacity : opacityTicks(plot.axis)) {
        const double y = plot.y(opacity);
        if (y < plot.area.top() - 1 || y > plot.area.bottom() + 1)
            continue;
        painter.setPen(QPen(faded(text, 0.12), 1));
        painter.drawLine(QPointF(plot.area.left(), y), QPointF(plot.area.right(), y));
        if (last - y < line * 0.8) // else one would stand on the other
            continue;
        last = y;
        painter.setPen(text);
        painter.drawText(QRectF(0, y - line / 2.0, plot.area.left() - 5, line), Qt::AlignRight | Qt::AlignVCenter,
                         percentText(100 * opacity));
    }
}

/// Lines as on logarithmic paper: at the powers of ten, and fainter ones at their multiples if these are not too many.
void paintDecades(QPainter& painter, const TransferPlot& plot, const QColor& text)
{
    const auto logarithm = [&](double value) { return plot.ofLogarithms ? value : std::log10(value); };
    const double first = std::floor(logarithm(plot.limits.least));
    const double last = logarithm(plot.limits.largest);
    const bool showsMultiples = last - first < mostDecadesWithMultiples;
    for (double power = first; power <= last; ++power)
        for (int multiple = 1; multiple < (showsMultiples ? 10 : 2); ++multiple) {
            const double x = plot.x(plot.ofLogarithms ? power + std::log10(multiple) : multiple * std::pow(10, power));
            if (x < plot.area.left() || x > plot.area.right())
                continue;
            painter.setPen(QPen(faded(text, multiple == 1 ? 0.3 : 0.1), 1));
            painter.drawLine(QPointF(x, plot.area.top()), QPointF(x, plot.area.bottom()));
        }
}

void paintValues(QPainter& painter, const CanvasScene& scene, const QColor& text)
{
    const TransferPlot& plot = scene.plot;
    if (plot.valueAxis == ValueAxis::Logarithmic || plot.ofLogarithms)
        paintDecades(painter, plot, text);
    painter.setPen(text);
    for (const AxisLabel& label : valueLabels(plot, painter.fontMetrics()))
        painter.drawText(label.place, Qt::AlignCenter | Qt::TextDontClip, label.text);
}

/// An arrow at an edge of the plot, with how many things lie beyond.
void paintOutside(QPainter& painter, const CanvasScene& scene, int count, int side)
{
    if (count == 0)
        return;
    const QRectF& area = scene.plot.area;
    const double edge = side < 0 ? area.left() + 2 : area.right() - 2;
    const double y = area.center().y();
    const QString text = QString::number(count);
    const double width = painter.fontMetrics().horizontalAdvance(text) + 18;
    const double height = painter.fontMetrics().height() + 2;
    const QRectF box(side < 0 ? edge : edge - width, y - height / 2, width, height);
    painter.setPen(Qt::NoPen);
    painter.setBrush(scene.palette.color(QPalette::Highlight));
    painter.drawRoundedRect(box, 3, 3);
    const double tip = side < 0 ? box.left() + 4 : box.right() - 4;
    painter.setBrush(scene.palette.color(QPalette::HighlightedText));
    painter.drawPolygon(QPolygonF({{tip, y}, {tip - side * 5, y - 4}, {tip - side * 5, y + 4}}));
    painter.setPen(scene.palette.color(QPalette::HighlightedText));
    painter.drawText(box.adjusted(side < 0 ? 12 : 4, 0, side < 0 ? -4 : -12, 0), Qt::AlignCenter, text);
}

void paintMarkerLine(QPainter& painter, const CanvasScene& scene, double x, const QPen& pen)
{
    const QRectF& area = scene.plot.area;
    QColor edge = scene.palette.color(QPalette::WindowText); // the colour may be that of the ground
    edge.setAlphaF(0.4F);
    const QPen ground(scene.palette.color(QPalette::Base), 3.5);
    for (const QPen& next : {ground, QPen(edge, pen.widthF() + 1.2, pen.style()), pen}) {
        painter.setPen(next);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
}

/// Of isovalues in a mode without their surfaces only the handle.
void paintMarker(QPainter& painter, const CanvasScene& scene, const EditorItem& item, const QColor& colour)
{
    const QRectF& area = scene.plot.area;
    const double x = scene.plot.x(*scene.state.valueOf(item));
    if (x < area.left() - 0.5 || x > area.right() + 0.5)
        return;
    const bool isCurrent = scene.state.current() == item;
    const QColor rim = scene.palette.color(isCurrent ? QPalette::Highlight : QPalette::WindowText);
    const bool isIsovalue = item.kind == EditorItem::Kind::Isovalue;
    const bool isOfMode = !isIsovalue || scene.showsIsovalues;
    const bool isHidden = isIsovalue && !(isOfMode && scene.state.host().isovalues()[item.index].visible);
    if (isOfMode || isCurrent)
        paintMarkerLine(painter, scene, x, QPen(colour, isCurrent ? 2.5 : 1.5, isHidden ? Qt::DotLine : Qt::SolidLine));
    painter.setPen(QPen(rim, isCurrent ? 2 : 1));
    painter.setBrush(isHidden ? scene.palette.color(QPalette::Base) : colour);
    const double top = area.top() - handleHeight;
    if (isIsovalue)
        painter.drawPolygon(QPolygonF({{x - halfHandle, top}, {x + halfHandle, top}, {x, area.top()}}));
    else // the straight side of the handle lies at the value
        painter.drawRect(
            QRectF(item.kind == EditorItem::Kind::MaskLeast ? x : x - halfHandle, top, halfHandle, handleHeight));
}

} // namespace

std::vector<AxisLabel> valueLabels(const TransferPlot& plot, const QFontMetrics& font)
{
    const double gap = font.horizontalAdvance("0");
    const double top = plot.area.bottom() + stripHeight + 5;
    const auto label = [&](double value, double share) {
        const QString text = textOfValue(value, plot.limits, plot.ofLogarithms);
        const double width = font.horizontalAdvance(text);
        return AxisLabel{
            text,
            {plot.area.left() + share * (plot.area.width() - width), top, width, static_cast<double>(font.height())}};
    };
    const std::array wanted{label(plot.limits.least, 0), label(plot.limits.largest, 1),
                            label(plot.valueAt(plot.area.center().x()), 0.5)}; // the most important first
    std::vector<AxisLabel> labels;
    for (const AxisLabel& next : wanted)
        if (std::ranges::none_of(labels, [&](const AxisLabel& other) {
                return other.place.adjusted(-gap, 0, gap, 0).intersects(next.place);
            }))
            labels.push_back(next);
    return labels;
}

void paintAxes(QPainter& painter, const CanvasScene& scene)
{
    const QColor text =
        scene.palette.color(scene.isEnabled ? QPalette::Active : QPalette::Disabled, QPalette::WindowText);
    paintOpacities(painter, scene, text);
    painter.setPen(QPen(faded(text, 0.5), 1));
    painter.drawLine(scene.plot.area.bottomLeft(), scene.plot.area.bottomRight());
    painter.drawLine(scene.plot.area.bottomLeft(), scene.plot.area.topLeft());
    if (scene.state.host().hasModel())
        paintValues(painter, scene, text);
}

void paintMarkers(QPainter& painter, const CanvasScene& scene)
{
    for (const EditorItem& item : scene.state.items()) {
        if (item.kind == EditorItem::Kind::Point)
            continue;
        QColor colour = scene.palette.color(QPalette::WindowText);
        if (item.kind == EditorItem::Kind::Isovalue) {
            const Isovalue& isovalue = scene.state.host().isovalues()[item.index];
            colour = QColor::fromRgbF(isovalue.red, isovalue.green, isovalue.blue);
        }
        paintMarker(painter, scene, item, colour);
    }
}

void paintPicked(QPainter& painter, const CanvasScene& scene)
{
    const auto value = pickedValue(scene.state);
    if (!value)
        return;
    const QRectF& area = scene.plot.area;
    const QColor highlight = scene.palette.color(QPalette::Highlight);
    const bool isLeft = *value<scene.plot.limits.least, isRight = *value> scene.plot.limits.largest;
    const double x = isLeft ? area.left() : isRight ? area.right() : scene.plot.x(*value);
    if (!isLeft && !isRight) {
        painter.setPen(QPen(scene.palette.color(QPalette::Base), 4));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setPen(QPen(highlight, 2, Qt::DashLine));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
    QString text = textOfValue(*value, scene.plot.limits, scene.plot.ofLogarithms);
    if (isLeft)
        text.prepend("◂ ");
    if (isRight)
        text.append(" ▸");
    QRectF label(x + 4, area.top() + 4, painter.fontMetrics().horizontalAdvance(text) + 10,
                 painter.fontMetrics().height() + 2);
    if (label.right() > area.right())
        label.moveRight(x - 4);
    painter.setPen(Qt::NoPen);
    painter.setBrush(highlight);
    painter.drawRoundedRect(label, 3, 3);
    painter.setPen(scene.palette.color(QPalette::HighlightedText));
    painter.drawText(label, Qt::AlignCenter, text);
}

OutsideCounts countOutside(const EditorState& state)
{
    const TransferLimits seen = state.shown();
    OutsideCounts counts;
    for (const EditorItem& item : state.items()) {
        counts.left += *state.valueOf(item) < seen.least;
        counts.right += *state.valueOf(item) > seen.largest;
    }
    return counts;
}

void paintWhatIsOutside(QPainter& painter, const CanvasScene& scene)
{
    const OutsideCounts counts = countOutside(scene.state);
    paintOutside(painter, scene, counts.left, -1);
    paintOutside(painter, scene, counts.right, 1);
}

} // namespace tetra
