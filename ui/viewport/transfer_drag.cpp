// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/transfer_drag.h"

#include "plugins/widgets/curves/whole_function.h"
#include "ui/viewport/viewport.h"

#include <QMouseEvent>

#include <cmath>
#include <utility>

namespace tetra {
namespace {

/// Over the height of the picture the function becomes 16 times as wide.
constexpr double doublings = 4;

} // namespace

TransferFunction draggedTransfer(const TransferFunction& function, QPointF pixels, QSizeF size, ValueRange range)
{
    const auto extent = extentOf(function);
    if (!extent || size.isEmpty())
        return function;
    const double middle = (extent->least + extent->largest) / 2;
    const double factor = std::exp2(-doublings * pixels.y() / size.height());
    return shifted(widened(function, middle, factor), pixels.x() / size.width() * (range.maximum - range.minimum));
}

TransferDrag::TransferDrag(Workbench& workbench, Viewport& viewport)
    : QObject(&viewport), workbench_(workbench), viewport_(viewport)
{
    viewport.installEventFilter(this);
}

bool TransferDrag::press(const QMouseEvent& event)
{
    if (event.button() != Qt::LeftButton || event.modifiers() != Qt::ControlModifier || !workbench_.session().model())
        return false;
    auto edited = workbench_.scenes().editedTransfer();
    if (!edited)
        return false;
    from_ = event.position();
    edited_ = *std::move(edited);
    workbench_.session().beginGesture();
    return true;
}

bool TransferDrag::eventFilter(QObject* watched, QEvent* event)
{
    const auto& mouse = static_cast<const QMouseEvent&>(*event); // read for mouse events alone
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        if (press(mouse))
            return true;
        break;
    case QEvent::MouseMove:
        if (from_) {
            workbench_.session().setTransfer(edited_.id,
                                             draggedTransfer(edited_.function, mouse.position() - *from_,
                                                             viewport_.size(), workbench_.session().range()));
            return true;
        }
        break;
    case QEvent::MouseButtonRelease:
        if (from_ && mouse.button() == Qt::LeftButton) {
            from_.reset();
            workbench_.session().endGesture();
            return true;
        }
        break;
    default: break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace tetra
