// SPDX-License-Identifier: GPL-3.0-or-later
// What keys do in the editor's plot.
#include "plugins/editors/transferfunction/point_clipboard.h"
#include "plugins/editors/transferfunction/transfer_canvas.h"
#include "plugins/widgets/curves/copying.h"

#include <QKeyEvent>

#include <algorithm>

namespace tetra {
namespace {

constexpr double keyStep = 0.01; ///< of the plot's width and height
constexpr double finePart = 0.1; ///< of that, with Ctrl
constexpr double farFactor = 5;  ///< of that, with Shift
constexpr double zoomPerKey = 0.8;
constexpr double panPerKey = 0.1; ///< of what is seen

std::optional<int> digitOf(const QKeyEvent& event)
{
    const int key = event.key();
    return key >= Qt::Key_0 && key <= Qt::Key_9 ? std::optional(key - Qt::Key_0) : std::nullopt;
}

TransferLimits zoomed(const TransferLimits& part, double factor)
{
    const double middle = (part.least + part.largest) / 2;
    return {middle + (part.least - middle) * factor, middle + (part.largest - middle) * factor};
}

} // namespace

bool isCanvasKey(const QKeyEvent& event)
{
    if (event.matches(QKeySequence::SelectAll) || event.matches(QKeySequence::Copy) ||
        event.matches(QKeySequence::Paste) || event.matches(QKeySequence::Delete))
        return true;
    const auto modifiers = event.modifiers() & ~Qt::KeypadModifier;
    if (modifiers != Qt::NoModifier && modifiers != Qt::ControlModifier)
        return false;
    constexpr std::array keys{Qt::Key_Insert, Qt::Key_C,    Qt::Key_D,    Qt::Key_Escape, Qt::Key_Plus, Qt::Key_Equal,
                              Qt::Key_Minus,  Qt::Key_Home, Qt::Key_Left, Qt::Key_Right,  Qt::Key_Up,   Qt::Key_Down};
    return digitOf(event) || std::ranges::find(keys, event.key()) != keys.end();
}

void TransferCanvas::keyPressEvent(QKeyEvent* event)
{
    if (!editByKey(*event) && !moveByKey(*event) && !lookByKey(*event) && !groupByKey(*event))
        QWidget::keyPressEvent(event);
}

bool TransferCanvas::editByKey(const QKeyEvent& event)
{
    const bool control = event.modifiers().testFlag(Qt::ControlModifier);
    if (event.matches(QKeySequence::SelectAll))
        state_.select(allPoints(function()));
    else if (event.matches(QKeySequence::Copy))
        copyPoints(state_);
    else if (event.matches(QKeySequence::Paste))
        pastePoints(state_, pointed_);
    else if (control && event.key() == Qt::Key_D)
        duplicatePoints(state_);
    else if (event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace)
        state_.removeCurrent();
    else if (event.key() == Qt::Key_C && event.modifiers() == Qt::NoModifier)
        emit colourWanted();
    else if (event.key() == Qt::Key_Insert)
        addPoint(state_, pointed_ ? pointed_ : pickedValue(state_));
    else if (event.key() == Qt::Key_Escape && state_.current().kind != EditorItem::Kind::None)
        state_.setCurrent({});
    else if (event.key() == Qt::Key_Escape && state_.host().picked())
        state_.host().forgetPicked();
    else
        return false;
    return true;
}

bool TransferCanvas::moveByKey(const QKeyEvent& event)
{
    if (event.modifiers().testFlag(Qt::AltModifier))
        return false;
    const double step = keyStep * (event.modifiers().testFlag(Qt::ControlModifier) ? finePart : 1) *
                        (event.modifiers().testFlag(Qt::ShiftModifier) ? farFactor : 1);
    switch (event.key()) {
    case Qt::Key_Left: moveCurrent(-1, 0, step); return true;
    case Qt::Key_Right: moveCurrent(1, 0, step); return true;
    case Qt::Key_Up: moveCurrent(0, 1, step); return true;
    case Qt::Key_Down: moveCurrent(0, -1, step); return true;
    default: return false;
    }
}

void TransferCanvas::moveCurrent(int right, int up, double step)
{
    const TransferPlot there = plot();
    const double along = right * step * there.extent();
    if (state_.currentPoint()) {
        const double height = up * step * (there.heights.largest - there.heights.least);
        state_.apply(moveSelected(function(), state_.selection(), {along, height, there.axis, there.valueAxis},
                                  state_.rule(), state_.limits()));
    } else if (const auto present = state_.valueOf(state_.current()); present && right != 0) {
        state_.setCurrentValue(valueOnAxis(placeOnAxis(*present, there.valueAxis) + along, there.valueAxis));
    }
}

/// Plus and minus zoom the values, with Ctrl the opacities; Alt and arrows go along the values; Home shows all.
bool TransferCanvas::lookByKey(const QKeyEvent& event)
{
    EditorView view = state_.view();
    const auto zoom = [&](double factor) {
        if (event.modifiers().testFlag(Qt::ControlModifier))
            view.heights = zoomed(view.heights, factor);
        else
            view.values = plot().between((1 - factor) / 2, (1 + factor) / 2);
    };
    const auto pan = [&](int right) { view.values = plot().between(right * panPerKey, 1 + right * panPerKey); };
    switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoom(zoomPerKey); break;
    case Qt::Key_Minus: zoom(1 / zoomPerKey); break;
    case Qt::Key_Left: pan(-1); break;
    case Qt::Key_Right: pan(1); break;
    case Qt::Key_Home:
        view.values.reset();
        view.heights = {};
        break;
    default: return false;
    }
    state_.setView(view);
    return true;
}

bool TransferCanvas::groupByKey(const QKeyEvent& event)
{
    const auto digit = digitOf(event);
    if (!digit)
        return false;
    if (event.modifiers().testFlag(Qt::ControlModifier))
        state_.apply(withGroup(function(), state_.selection(), *digit));
    else
        state_.select(pointsOfGroup(function(), *digit));
    return true;
}

} // namespace tetra
