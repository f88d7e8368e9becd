// SPDX-License-Identifier: GPL-3.0-or-later
// What the mouse does in the editor's plot.
#include "plugins/editors/transferfunction/transfer_canvas.h"

#include <QApplication>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr double zoomPerNotch = 0.8;
constexpr double panPerNotch = 0.1; ///< of what is seen
constexpr double notch = 120;       ///< as Qt counts the wheel

/// A part of an axis made larger or smaller around a place that stays.
TransferLimits zoomed(const TransferLimits& part, double around, double factor)
{
    return {around + (part.least - around) * factor, around + (part.largest - around) * factor};
}

TransferLimits moved(const TransferLimits& part, double by)
{
    return {part.least + by, part.largest + by};
}

double extentOf(const TransferLimits& limits)
{
    return limits.largest - limits.least;
}

} // namespace

void TransferCanvas::beginDrag(Grab::What what, QPointF from)
{
    grab_ = {what, from, from, plot(), state_.limits(), function(), state_.selection(), state_.view()};
}

void TransferCanvas::mousePressEvent(QMouseEvent* event)
{
    const QPointF place = event->position();
    if (event->button() == Qt::MiddleButton)
        return beginDrag(Grab::What::View, place);
    if (event->button() == Qt::RightButton)
        return pressMenu(place);
    if (event->button() != Qt::LeftButton)
        return;
    const EditorItem item = itemAt(place);
    if (item.kind == EditorItem::Kind::Point)
        return pressPoint(item.index, place, event->modifiers());
    if (item.kind != EditorItem::Kind::None) {
        state_.setCurrent(item);
        return beginDrag(Grab::What::Item, place);
    }
    const bool adds = event->modifiers().testAnyFlags(Qt::ControlModifier | Qt::ShiftModifier);
    if (!adds && addOnCurve(place))
        return;
    if (!adds)
        state_.setCurrent({});
    beginDrag(Grab::What::Band, place);
}

/// Alone, one more or less with Ctrl, all up to it with Shift; a drag moves all that are selected.
void TransferCanvas::pressPoint(std::size_t point, QPointF place, Qt::KeyboardModifiers modifiers)
{
    grab_ = {};
    if (modifiers.testFlag(Qt::ControlModifier)) {
        const bool was = std::ranges::binary_search(state_.selection(), point);
        return was ? state_.select(toggled(state_.selection(), point)) : state_.addToSelection(point);
    }
    if (modifiers.testFlag(Qt::ShiftModifier)) {
        const auto [from, to] =
            std::minmax({state_.currentPoint().value_or(point), point}); // a list: values, not references
        TransferSelection selection = state_.selection();
        for (std::size_t between = from; between <= to; ++between)
            selection.push_back(between);
        return state_.select(std::move(selection));
    }
    if (std::ranges::binary_search(state_.selection(), point))
        state_.addToSelection(point);
    else
        state_.setCurrent({EditorItem::Kind::Point, point});
    beginDrag(Grab::What::Points, place);
}

/// The menu that follows is of what is below the pointer, with all that is selected if that is.
void TransferCanvas::pressMenu(QPointF place)
{
    const EditorItem item = itemAt(place);
    if (item.kind == EditorItem::Kind::Point && std::ranges::binary_search(state_.selection(), item.index))
        state_.addToSelection(item.index);
    else if (item.kind != EditorItem::Kind::None)
        state_.setCurrent(item);
}

bool TransferCanvas::addOnCurve(QPointF place)
{
    const TransferPlot there = plot();
    if (!there.isOnCurve(state_.function(), place))
        return false;
    const auto added = withPoint(function(), there.valueAt(place.x()));
    if (!added)
        return false;
    state_.apply({added->function, {added->point}});
    beginDrag(Grab::What::Points, place);
    return true;
}

void TransferCanvas::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF place = event->position();
    point(plot().valueAt(place.x()));
    if (event->buttons() == Qt::NoButton || grab_.what == Grab::What::Nothing)
        return showCursorFor(place);
    grab_.to = place;
    if (!grab_.moved && (place - grab_.from).manhattanLength() < 2)
        return;
    grab_.moved = true;
    switch (grab_.what) {
    case Grab::What::Nothing: return;
    case Grab::What::Points: return dragPoints(place, event->modifiers().testFlag(Qt::ShiftModifier));
    case Grab::What::Item: return dragItem(place);
    case Grab::What::Band: return dragBand(place);
    case Grab::What::View: return dragView(place);
    }
}

/// Always from where the drag began, so that what a neighbour stopped on the way is not lost.
void TransferCanvas::dragPoints(QPointF to, bool oneWay)
{
    QPointF by = to - grab_.from;
    if (oneWay)
        by = std::abs(by.x()) >= std::abs(by.y()) ? QPointF(by.x(), 0) : QPointF(0, by.y());
    const QRectF& area = grab_.plot.area;
    const SelectionMove move{by.x() / area.width() * grab_.plot.extent(),
                             -by.y() / area.height() * extentOf(grab_.plot.heights), grab_.plot.axis,
                             grab_.plot.valueAxis};
    state_.apply(moveSelected(grab_.function, grab_.selection, move, state_.rule(), grab_.limits));
}

void TransferCanvas::dragItem(QPointF to)
{
    state_.setCurrentValue(grab_.plot.valueAt(to.x()));
}

void TransferCanvas::dragBand(QPointF to)
{
    TransferSelection selection = grab_.selection;
    for (const std::size_t point : grab_.plot.pointsIn(function(), QRectF(grab_.from, to).normalized()))
        selection.push_back(point);
    state_.select(std::move(selection));
    update();
}

void TransferCanvas::dragView(QPointF to)
{
    const QRectF& area = grab_.plot.area;
    const QPointF by = grab_.from - to;
    EditorView view = grab_.view;
    const double share = by.x() / area.width();
    view.values = grab_.plot.between(share, 1 + share);
    view.heights = moved(grab_.plot.heights, -by.y() / area.height() * extentOf(grab_.plot.heights));
    state_.setView(view);
}

/// A click on one of several selected points, without a drag, selects it alone.
void TransferCanvas::mouseReleaseEvent(QMouseEvent* event)
{
    Q_UNUSED(event);
    if (grab_.what == Grab::What::Points && !grab_.moved && state_.selection().size() > 1)
        state_.setCurrent(state_.current());
    grab_ = {};
    update();
}

/// A new point where it was clicked, which can be dragged on; a point that is there is asked about its colour. Lines
/// across the plot do not hinder that: they have handles above it.
void TransferCanvas::mouseDoubleClickEvent(QMouseEvent* event)
{
    const TransferPlot there = plot();
    const QPointF place = event->position();
    const EditorItem item = itemAt(place);
    if (event->button() != Qt::LeftButton)
        return;
    if (item.kind == EditorItem::Kind::Point)
        return emit colourWanted();
    if (item.kind != EditorItem::Kind::None && !there.area.contains(place))
        return;
    const auto added = withSeenPoint(function(), there.valueAt(place.x()));
    if (!added)
        return;
    state_.host().beginGesture();
    state_.apply(withOpacity(added->function, {added->point}, there.opacityAt(place.y())));
    beginDrag(Grab::What::Points, place);
}

void TransferCanvas::wheelEvent(QWheelEvent* event)
{
    const QPointF turned = QPointF(event->angleDelta()) / notch;
    const TransferPlot there = plot();
    EditorView view = state_.view();
    if (event->modifiers().testFlag(Qt::ControlModifier))
        view.heights = zoomed(view.heights, there.heightAt(event->position().y()), std::pow(zoomPerNotch, turned.y()));
    else if (event->modifiers().testFlag(Qt::ShiftModifier) || std::abs(turned.x()) > std::abs(turned.y())) {
        const double share = -(turned.x() + turned.y()) * panPerNotch;
        view.values = there.between(share, 1 + share);
    } else {
        const double share = std::clamp(there.shareAt(event->position().x()), 0.0, 1.0);
        const TransferLimits shares = zoomed({0, 1}, share, std::pow(zoomPerNotch, turned.y()));
        view.values = there.between(shares.least, shares.largest);
    }
    state_.setView(view);
    event->accept();
}

void TransferCanvas::leaveEvent(QEvent* event)
{
    point(std::nullopt);
    QWidget::leaveEvent(event);
}

void TransferCanvas::showCursorFor(QPointF place)
{
    switch (itemAt(place).kind) {
    case EditorItem::Kind::Point: return setCursor(Qt::SizeAllCursor);
    case EditorItem::Kind::Isovalue:
    case EditorItem::Kind::MaskLeast:
    case EditorItem::Kind::MaskLargest: return setCursor(Qt::SizeHorCursor);
    case EditorItem::Kind::None:
        return setCursor(plot().isOnCurve(state_.function(), place) ? Qt::CrossCursor : Qt::ArrowCursor);
    }
}

} // namespace tetra
