// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/gesture_watcher.h"

#include <QKeyEvent>
#include <QWidget>

namespace tetra {

GestureWatcher::GestureWatcher(QWidget* watched, std::function<void()> begin, std::function<void()> end)
    : QObject(watched), begin_(std::move(begin)), end_(std::move(end))
{
    watched->installEventFilter(this);
}

bool GestureWatcher::eventFilter(QObject* watched, QEvent* event)
{
    const auto repeated = [event] { return static_cast<QKeyEvent*>(event)->isAutoRepeat(); };
    switch (event->type()) {
    case QEvent::MouseButtonPress: begin_(); break;
    case QEvent::KeyPress:
        if (!repeated())
            begin_();
        break;
    case QEvent::KeyRelease:
        if (!repeated())
            end_();
        break;
    case QEvent::MouseButtonRelease:
    case QEvent::FocusOut: end_(); break;
    default: break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace tetra
