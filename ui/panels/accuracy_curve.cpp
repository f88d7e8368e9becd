// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/accuracy_curve.h"

#include "core/view/accuracy_scale.h"
#include "plugins/widgets/number_text.h"
#include "ui/session/accuracy_keys.h"
#include "ui/session/message_text.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr std::array<double, 6> labelledErrors{20, 4, 1, 0.2, 0.05, 0};
constexpr std::array<double, 6> minorErrors{10, 2, 0.5, 0.1, 0.02, 0.01};
constexpr double markRadius = 4.5;
constexpr double grabDistance = 5; ///< pixels from the line of the budget
constexpr int tallest = 220;       ///< more shows nothing more

/// "10", "1k", "100k", "1M": the axis has no room for more.
QString shortCount(double count)
{
    const QLocale locale;
    if (count >= 1e9)
        return AccuracyCurve::tr("%1G").arg(locale.toString(count / 1e9, 'g', 3));
    if (count >= 1e6)
        return AccuracyCurve::tr("%1M").arg(locale.toString(count / 1e6, 'g', 3));
    if (count >= 1e3)
        return AccuracyCurve::tr("%1k").arg(locale.toString(count / 1e3, 'g', 3));
    return locale.toString(count, 'g', 3);
}

/// The decades that the axis of tetrahedra spans, from a whole one to just above the most sites.
struct Decades {
    double first = 0;
    double last = 3;
};

Decades decadesOf(const std::vector<CurvePoint>& points)
{
    if (points.empty())
        return {};
    const double first = std::floor(std::log10(std::max<double>(static_cast<double>(points.front().tetrahedra), 1)));
    const double last = std::log10(std::max<double>(static_cast<double>(points.back().tetrahedra), 1)) + 0.1;
    return {first, std::max(last, first + 1)};
}

QColor faded(const QColor& colour, double opacity)
{
    QColor result = colour;
    result.setAlphaF(static_cast<float>(opacity));
    return result;
}

} // namespace

AccuracyCurve::AccuracyCurve(QWidget* parent) : QWidget(parent)
{
    setObjectName("accuracy.curve");
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMaximumHeight(tallest);
    setCursor(Qt::CrossCursor);
    setMouseTracking(true);
    setAccessibleName(tr("Tetrahedra against error"));
    setToolTip(
        tr("Number of tetrahedra needed for each error. Click, drag or use the arrow keys to choose the accuracy."));
}

void AccuracyCurve::setCurve(std::vector<CurvePoint> points)
{
    points_ = std::move(points);
    update();
}

void AccuracyCurve::setMarked(const CurvePoint& chosen)
{
    marked_ = chosen;
    setAccessibleDescription(tr("%1 tetrahedra at an %2 of %3")
                                 .arg(countText(chosen.tetrahedra), translatedText(textFor(errorNames, errorMeaning_)),
                                      percentText(chosen.error)));
    update();
}

void AccuracyCurve::setErrorMeaning(ErrorMeaning meaning)
{
    errorMeaning_ = meaning;
    update();
}

void AccuracyCurve::setBudget(std::optional<std::uint64_t> budget)
{
    budget_ = budget;
    update();
}

int AccuracyCurve::leftMargin() const
{
    return fontMetrics().horizontalAdvance("100k") + 8;
}

int AccuracyCurve::rightMargin() const
{
    return 12;
}

QSize AccuracyCurve::sizeHint() const
{
    return {300, 130}; // and what room there is
}

QSize AccuracyCurve::minimumSizeHint() const
{
    return {220, 120};
}

QRectF AccuracyCurve::plot() const
{
    const int line = fontMetrics().height();
    return QRectF(rect()).adjusted(leftMargin(), line + 4, -rightMargin(), -2 * line - 8);
}

double AccuracyCurve::xOf(double percent) const
{
    return plot().left() + accuracyPosition(percent) * plot().width();
}

double AccuracyCurve::yOf(double tetrahedra) const
{
    const auto [first, last] = decadesOf(points_);
    const double fraction = (std::log10(std::max(tetrahedra, 1.0)) - first) / (last - first);
    return plot().bottom() - std::clamp(fraction, 0.0, 1.0) * plot().height();
}

void AccuracyCurve::chooseAt(QPointF place)
{
    const QRectF area = plot();
    if (!draggingBudget_) {
        emit chosen(accuracyAt(std::clamp((place.x() - area.left()) / area.width(), 0.0, 1.0)));
        return;
    }
    const auto [first, last] = decadesOf(points_);
    const double fraction = std::clamp((area.bottom() - place.y()) / area.height(), 0.0, 1.0);
    const double tetrahedra = std::pow(10.0, first + fraction * (last - first));
    const double unit = std::pow(10.0, std::floor(std::log10(tetrahedra)) - 1); // two digits
    emit budgetChosen(static_cast<quint64>(std::round(tetrahedra / unit) * unit));
}

bool AccuracyCurve::isOnBudget(double y) const
{
    return budget_ && std::abs(yOf(static_cast<double>(*budget_)) - y) <= grabDistance;
}

void AccuracyCurve::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    draggingBudget_ = isOnBudget(event->position().y());
    if (!draggingBudget_)
        chooseAt(event->position());
}

void AccuracyCurve::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton))
        chooseAt(event->position());
    else
        setCursor(isOnBudget(event->position().y()) ? Qt::SplitVCursor : Qt::CrossCursor);
}

void AccuracyCurve::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        draggingBudget_ = false;
}

void AccuracyCurve::wheelEvent(QWheelEvent* event)
{
    if (const int steps = event->angleDelta().y() / 120; steps != 0)
        emit chosen(steppedAccuracy(marked_.error, steps));
}

void AccuracyCurve::keyPressEvent(QKeyEvent* event)
{
    if (const auto accuracy = accuracyByKey(marked_.error, event->key()))
        emit chosen(*accuracy);
    else
        QWidget::keyPressEvent(event);
}

void AccuracyCurve::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintAxes(painter);
    if (points_.empty())
        return;
    paintCurve(painter);
    paintBudget(painter);
    paintMark(painter);
}

void AccuracyCurve::paintAxes(QPainter& painter) const
{
    const QRectF area = plot();
    const QColor text = palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText);
    const int line = fontMetrics().height();
    painter.fillRect(area, palette().color(QPalette::Base));

    painter.setPen(QPen(faded(text, 0.12), 1));
    for (const double error : minorErrors)
        painter.drawLine(QPointF(xOf(error), area.top()), QPointF(xOf(error), area.bottom()));
    for (const double error : labelledErrors) {
        painter.setPen(QPen(faded(text, 0.12), 1));
        painter.drawLine(QPointF(xOf(error), area.top()), QPointF(xOf(error), area.bottom()));
        painter.setPen(text);
        painter.drawText(QRectF(xOf(error) - 30, area.bottom() + 4, 60, line), Qt::AlignHCenter,
                         QLocale().toString(error, 'g', 3));
    }
    const auto [first, last] = decadesOf(points_);
    for (double decade = first; decade <= last; ++decade) {
        const double y = yOf(std::pow(10.0, decade));
        painter.setPen(QPen(faded(text, 0.12), 1));
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(text);
        painter.drawText(QRectF(0, std::min(y - line / 2.0, area.bottom() - line + 2), area.left() - 5, line),
                         Qt::AlignRight | Qt::AlignVCenter, shortCount(std::pow(10.0, decade)));
    }
    painter.setPen(QPen(faded(text, 0.5), 1));
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    painter.drawLine(area.bottomLeft(), area.topLeft());
    painter.setPen(text);
    painter.drawText(QRectF(0, 0, width(), line), Qt::AlignLeft, tr("Tetrahedra"));
    painter.drawText(QRectF(area.left(), area.bottom() + line + 5, area.width(), line), Qt::AlignHCenter,
                     tr("%1, % of the value range").arg(translatedText(textFor(errorLabels, errorMeaning_))));
}

void AccuracyCurve::paintCurve(QPainter& painter) const
{
    QPainterPath path(QPointF(xOf(points_.front().error), yOf(static_cast<double>(points_.front().tetrahedra))));
    for (const CurvePoint& point : points_)
        path.lineTo(xOf(point.error), yOf(static_cast<double>(point.tetrahedra)));
    QPainterPath below = path;
    below.lineTo(plot().bottomRight());
    below.lineTo(plot().bottomLeft());
    const QColor colour = palette().color(QPalette::Highlight);
    painter.fillPath(below, faded(colour, 0.12));
    painter.setPen(QPen(colour, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

/// What lies above the line is more than the budget.
void AccuracyCurve::paintBudget(QPainter& painter) const
{
    if (!budget_)
        return;
    const QRectF area = plot();
    const double y = yOf(static_cast<double>(*budget_));
    const QColor text = palette().color(QPalette::WindowText);
    painter.fillRect(QRectF(area.topLeft(), QPointF(area.right(), y)), faded(text, 0.1));
    painter.setPen(QPen(text, 1.5));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
}

void AccuracyCurve::paintMark(QPainter& painter) const
{
    const QPointF mark(xOf(marked_.error), yOf(static_cast<double>(marked_.tetrahedra)));
    const QColor text = palette().color(QPalette::WindowText);
    painter.setPen(QPen(faded(text, 0.6), 1, Qt::DashLine));
    painter.drawLine(QPointF(mark.x(), plot().bottom()), mark);
    painter.drawLine(QPointF(plot().left(), mark.y()), mark);
    painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
    painter.setBrush(hasFocus() ? palette().color(QPalette::Highlight) : text);
    painter.drawEllipse(mark, markRadius, markRadius);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

} // namespace tetra
