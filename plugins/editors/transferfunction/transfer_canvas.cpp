// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/transfer_canvas.h"

#include "plugins/widgets/gesture_watcher.h"
#include "plugins/widgets/number_text.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr double handleGrab = 7; // pixels to either side
constexpr double lineGrab = 3;

} // namespace

TransferCanvas::TransferCanvas(EditorState& state, QWidget* parent) : QWidget(parent), state_(state)
{
    setObjectName("transfer.canvas");
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setContextMenuPolicy(Qt::CustomContextMenu);
    setAccessibleName(tr("Transfer function"));
    setToolTip(
        tr("Opacity against value. Drag points, click the curve or double click to add one, Delete removes; arrow "
           "keys move (finer with Ctrl, farther with Shift), Tab goes to the next. A frame or Ctrl+click selects "
           "several. The wheel zooms the values, with Ctrl the opacities; Home shows all. Ctrl+digit makes a "
           "group, the digit selects it. Behind: how often the values occur in the mesh."));
    new GestureWatcher(this, state.host());
    connect(&state, &EditorState::selectionChanged, this, [this] {
        describeCurrent();
        update();
    });
    connect(&state, &EditorState::viewChanged, this, qOverload<>(&QWidget::update));
    connect(&state, &EditorState::editedChanged, this, [this] { grab_ = {}; }); // a drag was of the other function
}

void TransferCanvas::select(std::optional<std::size_t> point)
{
    state_.setCurrent(point ? EditorItem{EditorItem::Kind::Point, *point} : EditorItem{});
}

TransferPlot TransferCanvas::plot() const
{
    return {plotArea(rect(), fontMetrics()),
            state_.shown(),
            state_.view().heights,
            state_.view().axis,
            state_.valueAxis(),
            state_.ofLogarithms()};
}

CanvasScene TransferCanvas::scene() const
{
    CanvasScene scene{state_, plot(), palette()};
    scene.isEnabled = isEnabled();
    scene.hasFocus = hasFocus();
    scene.showsIsovalues = state_.showsIsovalues();
    if (grab_.what == Grab::What::Band && grab_.moved)
        scene.band = QRectF(grab_.from, grab_.to).normalized();
    return scene;
}

EditorItem TransferCanvas::itemAt(QPointF place) const
{
    const TransferPlot there = plot();
    if (const auto point = there.pointAt(function(), place))
        return {EditorItem::Kind::Point, *point};
    const bool onHandle = place.y() < there.area.top();
    if (!there.area.adjusted(-handleGrab, -there.area.top(), handleGrab, 0).contains(place) ||
        (!onHandle && there.isOnCurve(state_.function(), place)))
        return {};
    const auto isThere = [onHandle](EditorItem::Kind kind) { // an isovalue's line is only looked at
        return kind != EditorItem::Kind::Point && (onHandle || kind != EditorItem::Kind::Isovalue);
    };
    EditorItem nearest;
    double least = onHandle ? handleGrab : lineGrab;
    for (const EditorItem& item : state_.items()) {
        const double distance = std::abs(there.x(*state_.valueOf(item)) - place.x());
        if (isThere(item.kind) && distance <= least) {
            nearest = item;
            least = distance;
        }
    }
    return nearest;
}

QSize TransferCanvas::sizeHint() const
{
    return {300, 200};
}

QSize TransferCanvas::minimumSizeHint() const
{
    return {200, 120};
}

void TransferCanvas::describeCurrent()
{
    const std::size_t points = function().points.size();
    const EditorItem current = state_.current();
    if (current.kind == EditorItem::Kind::None)
        return setAccessibleDescription(tr("%1 points").arg(points));
    if (current.kind != EditorItem::Kind::Point)
        return setAccessibleDescription(tipFor(current));
    const TransferPoint& point = function().points[current.index];
    QString text = tr("Point %1 of %2: value %3, opacity %4")
                       .arg(current.index + 1)
                       .arg(points)
                       .arg(wholeTextOf(point.value), percentText(100.0 * point.opacity));
    if (point.group)
        text += ", " + tr("group %1").arg(*point.group);
    if (state_.selection().size() > 1)
        text += "; " + tr("%1 points are selected").arg(state_.selection().size());
    setAccessibleDescription(text);
}

/// Among all values, not only those that are seen.
QString TransferCanvas::wholeTextOf(double value) const
{
    const TransferLimits limits = state_.limits();
    return state_.ofLogarithms() ? antilogarithmText(value, limits.largest - limits.least)
                                 : numberInRange(value, limits.least, limits.largest);
}

/// For tooltips and for people who hear what they do not see.
QString TransferCanvas::tipFor(const EditorItem& item) const
{
    const auto value = [this, &item] { return wholeTextOf(*state_.valueOf(item)); };
    switch (item.kind) {
    case EditorItem::Kind::None: return toolTip();
    case EditorItem::Kind::Point: {
        const TransferPoint& point = function().points[item.index];
        const QString text = tr("Value %1, opacity %2").arg(value(), percentText(100.0 * point.opacity));
        return point.group ? text + ", " + tr("group %1").arg(*point.group) : text;
    }
    case EditorItem::Kind::Isovalue:
        return tr("Isovalue %1 of %2: %3").arg(item.index + 1).arg(state_.host().isovalues().size()).arg(value());
    case EditorItem::Kind::MaskLeast: return tr("Lower end of the mask: %1").arg(value());
    case EditorItem::Kind::MaskLargest: return tr("Upper end of the mask: %1").arg(value());
    }
    return {};
}

void TransferCanvas::point(std::optional<double> value)
{
    pointed_ = value;
    emit pointedChanged();
}

bool TransferCanvas::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), tipFor(itemAt(help->pos())), this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride && isCanvasKey(*static_cast<QKeyEvent*>(event)))
        event->accept();
    return QWidget::event(event);
}

void TransferCanvas::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event);
    QPainter painter(this);
    paintCanvas(painter, scene(), rect());
}

/// From item to item first, then on.
bool TransferCanvas::focusNextPrevChild(bool next)
{
    const std::vector<EditorItem> items = state_.items();
    const auto current = std::ranges::find(items, state_.current());
    const bool none = current == items.end();
    const bool isEnd = items.empty() || (!none && (next ? current + 1 == items.end() : current == items.begin()));
    if (!hasFocus() || isEnd)
        return QWidget::focusNextPrevChild(next);
    state_.setCurrent(none ? (next ? items.front() : items.back()) : (next ? current[1] : current[-1]));
    return true;
}

} // namespace tetra
