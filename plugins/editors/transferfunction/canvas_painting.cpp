// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/canvas_painting.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace tetra {
namespace {

constexpr double pointRadius = 5;

void paintHistogram(QPainter& painter, const CanvasScene& scene)
{
    const TransferPlot& plot = scene.plot;
    const auto histogram = histogramOn(plot.valueAxis, scene.state.host());
    if (!histogram || histogram->counts.empty())
        return;
    const double extent = histogram->largest - histogram->least;
    const auto parts = static_cast<double>(histogram->counts.size());
    painter.setRenderHint(QPainter::Antialiasing, false);
    const QColor colour = faded(scene.palette.color(QPalette::WindowText), 0.18);
    for (std::size_t part = 0; part < histogram->counts.size(); ++part) {
        const auto index = static_cast<double>(part);
        const double left = plot.xOfPlace(histogram->least + extent * index / parts);
        const double right = plot.xOfPlace(histogram->least + extent * (index + 1) / parts);
        const double height =
            barHeight(histogram->counts[part], histogram->highest(), scene.state.view().logarithmicCounts) *
            plot.area.height();
        painter.fillRect(QRectF(QPointF(left, plot.area.bottom() - height), QPointF(right, plot.area.bottom())),
                         colour);
    }
    painter.setRenderHint(QPainter::Antialiasing, true);
}

/// The values that the mask hides.
void paintMask(QPainter& painter, const CanvasScene& scene)
{
    const auto& mask = scene.function().mask;
    if (!mask)
        return;
    const QRectF& area = scene.plot.area;
    const QBrush veil(faded(scene.palette.color(QPalette::WindowText), 0.25), Qt::BDiagPattern);
    const double left = std::clamp(scene.plot.x(mask->least), area.left(), area.right());
    const double right = std::clamp(scene.plot.x(mask->largest), area.left(), area.right());
    painter.fillRect(QRectF(area.topLeft(), QPointF(left, area.bottom())), veil);
    painter.fillRect(QRectF(QPointF(right, area.top()), area.bottomRight()), veil);
}

/// As it is evaluated: straight in extinction, not in opacity.
QPolygonF curveOf(const CanvasScene& scene)
{
    const TransferPlot& plot = scene.plot;
    const JoinedFunction& function = scene.function();
    std::vector<double> stops;
    for (double x = plot.area.left(); x < plot.area.right(); x += 2)
        stops.push_back(plot.valueAt(x));
    stops.push_back(plot.limits.largest);
    QPolygonF line;
    std::size_t next = 0;
    while (next < function.points.size() && function.points[next].value < plot.limits.least)
        ++next;
    for (const double value : stops) {
        for (; next < function.points.size() && function.points[next].value <= value; ++next)
            line.append({plot.x(function.points[next].value), plot.y(function.points[next].opacity)});
        line.append({plot.x(value), plot.y(opacityOf(scene.state.function(), value))});
    }
    return line;
}

void paintCurve(QPainter& painter, const CanvasScene& scene)
{
    if (scene.function().points.empty())
        return;
    const QPolygonF line = curveOf(scene);
    const QColor text = scene.palette.color(QPalette::WindowText);
    painter.setPen(QPen(scene.palette.color(QPalette::Base), 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setPen(QPen(faded(text, 0.8), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
}

/// A strip of the colours below the plot.
void paintColours(QPainter& painter, const CanvasScene& scene)
{
    const TransferPlot& plot = scene.plot;
    const QRectF strip(plot.area.left(), plot.area.bottom() + 3, plot.area.width(), stripHeight);
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (double x = strip.left(); x < strip.right(); x += 1)
        painter.fillRect(QRectF(x, strip.top(), std::min(1.0, strip.right() - x), strip.height()),
                         colourAt(scene.state.function(), plot.valueAt(x + 0.5)));
    painter.setRenderHint(QPainter::Antialiasing, true);
}

/// A disc; of a step's sides each a half of one, with its straight edge at the value.
QPainterPath markOf(QPointF place, double radius, int side)
{
    QPainterPath path;
    if (side == 0) {
        path.addEllipse(place, radius, radius);
        return path;
    }
    const QPointF middle(place.x() - side * (radius - 2), place.y());
    path.moveTo(middle + QPointF(0, -radius));
    path.arcTo(QRectF(middle.x() - radius, middle.y() - radius, 2 * radius, 2 * radius), 90, side < 0 ? 180 : -180);
    path.closeSubpath();
    return path;
}

void paintPoints(QPainter& painter, const CanvasScene& scene)
{
    const JoinedFunction& function = scene.function();
    const QColor highlight = scene.palette.color(QPalette::Highlight);
    for (std::size_t i = 0; i < function.points.size(); ++i) {
        const TransferPoint& point = function.points[i];
        const bool isSelected = std::ranges::binary_search(scene.state.selection(), i);
        const bool isCurrent = scene.state.currentPoint() == i;
        const double radius = isSelected ? pointRadius + 1.5 : pointRadius;
        const QPainterPath mark = markOf(scene.plot.place(function, i), radius, sideOf(function, i));
        painter.setBrush(QColor::fromRgbF(point.colour[0], point.colour[1], point.colour[2]));
        painter.setPen(QPen(scene.palette.color(QPalette::Base), isSelected ? 5 : 3));
        painter.drawPath(mark);
        painter.setPen(QPen(isSelected ? highlight : scene.palette.color(QPalette::WindowText),
                            isCurrent ? 3.0 : (isSelected ? 2.0 : 1.2)));
        painter.drawPath(mark);
    }
}

/// The group of each point that has one, beside it.
void paintGroups(QPainter& painter, const CanvasScene& scene)
{
    QFont font = painter.font();
    font.setBold(true);
    painter.setFont(font);
    for (std::size_t i = 0; i < scene.function().points.size(); ++i)
        if (const auto group = scene.function().points[i].group) {
            const QRectF label = groupLabel(scene.plot, scene.function(), i, painter.fontMetrics());
            painter.setPen(Qt::NoPen);
            painter.setBrush(faded(scene.palette.color(QPalette::Base), 0.85));
            painter.drawRoundedRect(label, 3, 3);
            painter.setPen(scene.palette.color(QPalette::WindowText));
            painter.drawText(label, Qt::AlignCenter, QString::number(*group));
        }
}

void paintBand(QPainter& painter, const CanvasScene& scene)
{
    if (!scene.band)
        return;
    const QColor highlight = scene.palette.color(QPalette::Highlight);
    painter.setPen(QPen(highlight, 1));
    painter.setBrush(faded(highlight, 0.15));
    painter.drawRect(scene.band->toAlignedRect());
}

void paintFocus(QPainter& painter, const CanvasScene& scene, const QRectF& canvas)
{
    if (!scene.hasFocus)
        return;
    painter.setPen(QPen(scene.palette.color(QPalette::Highlight), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(canvas.adjusted(0.5, 0.5, -0.5, -0.5));
}

} // namespace

QColor faded(const QColor& colour, double opacity)
{
    QColor result = colour;
    result.setAlphaF(static_cast<float>(opacity));
    return result;
}

QColor colourAt(const TransferFunction& function, double value)
{
    const auto channel = [](double number) { return static_cast<float>(std::clamp(number, 0.0, 1.0)); };
    const TransferSample sample = evaluateUnmasked(function, value);
    return QColor::fromRgbF(channel(sample.colour[0]), channel(sample.colour[1]), channel(sample.colour[2]));
}

QRectF plotArea(const QRectF& canvas, const QFontMetrics& font)
{
    const int left = font.horizontalAdvance("100 %") + 10;
    return canvas.adjusted(left, pointRadius + handleHeight + 3, -pointRadius - 4, -font.height() - stripHeight - 8);
}

std::shared_ptr<const ValueHistogram> histogramOn(ValueAxis axis, const EditorHost& host)
{
    return axis == ValueAxis::Logarithmic ? host.logarithmicHistogram() : host.histogram();
}

QRectF groupLabel(const TransferPlot& plot, const JoinedFunction& function, std::size_t point, const QFontMetrics& font)
{
    const QPointF place = plot.place(function, point);
    QRectF label(0, 0, font.horizontalAdvance("0") + 4, font.height());
    label.moveBottomLeft(place + QPointF(pointRadius, -pointRadius + 2));
    if (label.top() < 0)
        label.moveTop(place.y() + pointRadius - 2);
    if (label.right() > plot.area.right() + pointRadius + 4)
        label.moveRight(place.x() - pointRadius);
    return label;
}

void paintCanvas(QPainter& painter, const CanvasScene& scene, const QRectF& canvas)
{
    const QRectF& area = scene.plot.area;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(area, scene.palette.color(QPalette::Base));
    painter.save();
    painter.setClipRect(area);
    paintHistogram(painter, scene);
    painter.restore();
    paintAxes(painter, scene);
    if (scene.state.host().hasModel()) {
        painter.save();
        painter.setClipRect(area.adjusted(0, -2, 0, 2));
        paintMask(painter, scene);
        paintCurve(painter, scene);
        painter.restore();
        paintColours(painter, scene);
        paintMarkers(painter, scene);
        painter.save();
        painter.setClipRect(area.adjusted(-pointRadius - 4, -pointRadius - 4, pointRadius + 4, pointRadius + 4));
        paintPoints(painter, scene);
        paintGroups(painter, scene);
        painter.restore();
        paintPicked(painter, scene);
        paintWhatIsOutside(painter, scene);
        paintBand(painter, scene);
    }
    paintFocus(painter, scene, canvas);
}

} // namespace tetra
