// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/transfer_canvas.h"

#include "plugins/widgets/gesture_watcher.h"
#include "plugins/widgets/number_text.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {
namespace {

constexpr double pointRadius = 5;
constexpr double stripHeight = 10;
constexpr double keyStep = 0.01; ///< of the plot's width and height
constexpr double finePart = 0.1; ///< of that, with Ctrl
constexpr std::array<double, 5> labelledOpacities{0, 0.1, 0.25, 0.5, 1};

QColor faded(const QColor& colour, double opacity)
{
    QColor result = colour;
    result.setAlphaF(static_cast<float>(opacity));
    return result;
}

QColor colourAt(const TransferFunction& function, double value)
{
    const auto channel = [](double number) { return static_cast<float>(std::clamp(number, 0.0, 1.0)); };
    const TransferSample sample = evaluate(function, value);
    return QColor::fromRgbF(channel(sample.colour[0]), channel(sample.colour[1]), channel(sample.colour[2]));
}

} // namespace

TransferCanvas::TransferCanvas(EditorHost& host, QWidget* parent) : QWidget(parent), host_(host)
{
    setObjectName("transfer.canvas");
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Transfer function"));
    setToolTip(tr("Opacity against value. Drag points, double click to add one, Delete removes it; arrow keys move it "
                  "(finer with Ctrl), Tab goes to the next. Behind: how often the values occur in the mesh."));
    new GestureWatcher(this, host);
}

const TransferFunction& TransferCanvas::function() const
{
    return host_.function();
}

/// The range of the data, and what of the function reaches beyond it: nothing acts unseen.
TransferLimits TransferCanvas::limits() const
{
    TransferLimits limits{host_.range().minimum, host_.range().maximum};
    if (!function().points.empty()) {
        limits.least = std::min(limits.least, function().points.front().value);
        limits.largest = std::max(limits.largest, function().points.back().value);
    }
    return limits;
}

TransferPlot TransferCanvas::plot() const
{
    const int line = fontMetrics().height();
    const int left = fontMetrics().horizontalAdvance("100 %") + 10;
    return {QRectF(rect()).adjusted(left, pointRadius + 2, -pointRadius - 4, -line - stripHeight - 8), limits()};
}

QSize TransferCanvas::sizeHint() const
{
    return {300, 190};
}

QSize TransferCanvas::minimumSizeHint() const
{
    return {200, 110};
}

void TransferCanvas::select(std::optional<std::size_t> point)
{
    if (point && *point >= function().points.size())
        point.reset();
    selected_ = point;
    describeSelected();
    update();
    emit selectionChanged();
}

void TransferCanvas::setLogarithmic(bool logarithmic)
{
    logarithmic_ = logarithmic;
    update();
}

void TransferCanvas::refresh()
{
    select(selected_);
}

void TransferCanvas::describeSelected()
{
    if (!selected_)
        return setAccessibleDescription(tr("%1 points").arg(function().points.size()));
    const TransferPoint& point = function().points[*selected_];
    setAccessibleDescription(tr("Point %1 of %2: value %3, opacity %4")
                                 .arg(*selected_ + 1)
                                 .arg(function().points.size())
                                 .arg(QLocale().toString(point.value, 'g', 6), percentText(100.0 * point.opacity)));
}

void TransferCanvas::move(double value, double opacity)
{
    if (selected_)
        host_.setFunction(withMovedPoint(function(), *selected_, value, opacity, limits()));
}

void TransferCanvas::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    const TransferPlot there = plot();
    select(there.pointAt(function(), event->position()));
    dragging_ = selected_.has_value();
    if (dragging_)
        grabbedBeside_ = there.place(function().points[*selected_]) - event->position();
}

void TransferCanvas::mouseMoveEvent(QMouseEvent* event)
{
    const TransferPlot there = plot();
    if (dragging_ && event->buttons().testFlag(Qt::LeftButton)) {
        const QPointF place = event->position() + grabbedBeside_;
        move(there.valueAt(place.x()), there.opacityAt(place.y()));
    } else {
        setCursor(there.pointAt(function(), event->position()) ? Qt::SizeAllCursor : Qt::ArrowCursor);
    }
}

void TransferCanvas::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        dragging_ = false;
}

/// A new point where it was clicked, which can be dragged on.
void TransferCanvas::mouseDoubleClickEvent(QMouseEvent* event)
{
    const TransferPlot there = plot();
    if (event->button() != Qt::LeftButton || there.pointAt(function(), event->position()))
        return;
    host_.beginGesture();
    const auto added = withPoint(function(), there.valueAt(event->position().x()));
    if (!added)
        return;
    host_.setFunction(added->function);
    select(added->point);
    move(function().points[added->point].value, there.opacityAt(event->position().y()));
    dragging_ = true;
    grabbedBeside_ = {};
}

void TransferCanvas::keyPressEvent(QKeyEvent* event)
{
    const bool fine = event->modifiers().testFlag(Qt::ControlModifier);
    switch (event->key()) {
    case Qt::Key_Left: return moveByKey(-1, 0, fine);
    case Qt::Key_Right: return moveByKey(1, 0, fine);
    case Qt::Key_Up: return moveByKey(0, 1, fine);
    case Qt::Key_Down: return moveByKey(0, -1, fine);
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        if (selected_)
            host_.setFunction(withoutPoint(function(), *selected_));
        return;
    default: QWidget::keyPressEvent(event);
    }
}

void TransferCanvas::moveByKey(int right, int up, bool fine)
{
    if (!selected_)
        return;
    const TransferPlot there = plot();
    const TransferPoint& point = function().points[*selected_];
    const double step = keyStep * (fine ? finePart : 1);
    const double value = point.value + right * step * (there.limits.largest - there.limits.least);
    const double height = std::sqrt(static_cast<double>(point.opacity)) + up * step;
    move(right != 0 ? value : point.value, up != 0 ? std::pow(std::clamp(height, 0.0, 1.0), 2) : point.opacity);
}

/// From point to point first, then on.
bool TransferCanvas::focusNextPrevChild(bool next)
{
    const std::size_t count = function().points.size();
    const std::size_t before = selected_.value_or(next ? count : 0);
    const bool isEnd = selected_ ? (next ? *selected_ + 1 >= count : *selected_ == 0) : count == 0;
    if (!hasFocus() || isEnd)
        return QWidget::focusNextPrevChild(next);
    select(next ? (selected_ ? before + 1 : 0) : (selected_ ? before - 1 : count - 1));
    return true;
}

void TransferCanvas::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(plot().area, palette().color(QPalette::Base));
    paintHistogram(painter);
    paintAxes(painter);
    if (!host_.hasModel())
        return;
    paintCurve(painter);
    paintColours(painter);
    paintPoints(painter);
}

void TransferCanvas::paintHistogram(QPainter& painter) const
{
    const auto histogram = host_.histogram();
    if (!histogram || histogram->counts.empty())
        return;
    const TransferPlot there = plot();
    const double extent = histogram->largest - histogram->least;
    const auto parts = static_cast<double>(histogram->counts.size());
    painter.setRenderHint(QPainter::Antialiasing, false);
    const QColor colour = faded(palette().color(QPalette::WindowText), 0.18);
    for (std::size_t part = 0; part < histogram->counts.size(); ++part) {
        const auto index = static_cast<double>(part);
        const double left = there.x(histogram->least + extent * index / parts);
        const double right = there.x(histogram->least + extent * (index + 1) / parts);
        const double height =
            barHeight(histogram->counts[part], histogram->highest(), logarithmic_) * there.area.height();
        painter.fillRect(QRectF(QPointF(left, there.area.bottom() - height), QPointF(right, there.area.bottom())),
                         colour);
    }
    painter.setRenderHint(QPainter::Antialiasing, true);
}

void TransferCanvas::paintAxes(QPainter& painter) const
{
    const TransferPlot there = plot();
    const QColor text = palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText);
    const int line = fontMetrics().height();
    for (const double opacity : labelledOpacities) {
        const double y = there.y(opacity);
        painter.setPen(QPen(faded(text, 0.12), 1));
        painter.drawLine(QPointF(there.area.left(), y), QPointF(there.area.right(), y));
        painter.setPen(text);
        painter.drawText(QRectF(0, y - line / 2.0, there.area.left() - 5, line), Qt::AlignRight | Qt::AlignVCenter,
                         percentText(100 * opacity));
    }
    painter.setPen(QPen(faded(text, 0.5), 1));
    painter.drawLine(there.area.bottomLeft(), there.area.bottomRight());
    painter.drawLine(there.area.bottomLeft(), there.area.topLeft());
    if (!host_.hasModel())
        return;
    painter.setPen(text);
    const double middle = (there.limits.least + there.limits.largest) / 2;
    const QRectF labels(there.area.left(), there.area.bottom() + stripHeight + 5, there.area.width(), line);
    const auto number = [](double value) { return QLocale().toString(value, 'g', 4); };
    painter.drawText(labels, Qt::AlignLeft, number(there.limits.least));
    painter.drawText(labels, Qt::AlignHCenter, number(middle));
    painter.drawText(labels, Qt::AlignRight, number(there.limits.largest));
}

/// As it is evaluated: straight in extinction, not in opacity.
void TransferCanvas::paintCurve(QPainter& painter) const
{
    const TransferPlot there = plot();
    if (function().points.empty())
        return;
    std::vector<double> stops;
    for (double x = there.area.left(); x < there.area.right(); x += 2)
        stops.push_back(there.valueAt(x));
    stops.push_back(there.limits.largest);
    QPolygonF line;
    std::size_t next = 0;
    for (const double value : stops) {
        for (; next < function().points.size() && function().points[next].value <= value; ++next)
            line.append(there.place(function().points[next]));
        line.append(QPointF(there.x(value), there.y(opacityOf(function(), value))));
    }
    const QColor text = palette().color(QPalette::WindowText);
    painter.setPen(QPen(palette().color(QPalette::Base), 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setPen(QPen(faded(text, 0.8), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
}

/// A strip of the colours below the plot.
void TransferCanvas::paintColours(QPainter& painter) const
{
    const TransferPlot there = plot();
    const QRectF strip(there.area.left(), there.area.bottom() + 3, there.area.width(), stripHeight);
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (double x = strip.left(); x < strip.right(); x += 1)
        painter.fillRect(QRectF(x, strip.top(), 1, strip.height()), colourAt(function(), there.valueAt(x + 0.5)));
    painter.setRenderHint(QPainter::Antialiasing, true);
}

void TransferCanvas::paintPoints(QPainter& painter) const
{
    const TransferPlot there = plot();
    const QColor highlight = palette().color(QPalette::Highlight);
    for (std::size_t i = 0; i < function().points.size(); ++i) {
        const TransferPoint& point = function().points[i];
        const bool isSelected = selected_ == i;
        const double radius = isSelected ? pointRadius + 1.5 : pointRadius;
        painter.setBrush(QColor::fromRgbF(point.colour[0], point.colour[1], point.colour[2]));
        painter.setPen(QPen(palette().color(QPalette::Base), isSelected ? 5 : 3));
        painter.drawEllipse(there.place(point), radius, radius);
        painter.setPen(QPen(isSelected ? highlight : palette().color(QPalette::WindowText), isSelected ? 2.5 : 1.2));
        painter.drawEllipse(there.place(point), radius, radius);
    }
    if (hasFocus()) {
        painter.setPen(QPen(highlight, 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

} // namespace tetra
