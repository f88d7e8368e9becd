// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/wheel_guard.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QEvent>
#include <QScrollBar>
#include <QWidget>

namespace tetra {
namespace {

bool onlyScrolls(const QWidget& widget)
{
    return qobject_cast<const QAbstractScrollArea*>(&widget) != nullptr ||
           qobject_cast<const QScrollBar*>(&widget) != nullptr;
}

bool hasKeys(const QWidget& widget)
{
    const QWidget* focused = QApplication::focusWidget();
    return focused != nullptr && (&widget == focused || widget.focusProxy() == focused || widget.isAncestorOf(focused));
}

} // namespace

WheelGuard::WheelGuard(const QWidget& picture, QObject* parent) : QObject(parent), picture_(picture)
{
    qApp->installEventFilter(this);
}

bool WheelGuard::isKeptFromWheel(const QWidget& widget) const
{
    return (widget.focusPolicy() & Qt::ClickFocus) != 0 && !onlyScrolls(widget) && !hasKeys(widget) &&
           &widget != &picture_ && !picture_.isAncestorOf(&widget);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event)
{
    if (!watched->isWidgetType())
        return false;
    auto& widget = static_cast<QWidget&>(*watched);
    // Qt gives the keys to a widget of this policy before the wheel comes to it: from here on by clicks and by Tab
    // only.
    if (event->type() == QEvent::Polish && widget.focusPolicy() == Qt::WheelFocus)
        widget.setFocusPolicy(Qt::StrongFocus);
    if (event->type() != QEvent::Wheel || !isKeptFromWheel(widget))
        return false;
    event->ignore(); // so that it goes on to what is around the control
    return true;
}

} // namespace tetra
