// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/gesture_watcher.h"

#include <QKeyEvent>
#include <QWidget>

namespace tetra {

GestureWatcher::GestureWatcher(QWidget* watched, Session& session) : QObject(watched), session_(session)
{
    watched->installEventFilter(this);
}

bool GestureWatcher::eventFilter(QObject* watched, QEvent* event)
{
    const auto repeated = [event] { return static_cast<QKeyEvent*>(event)->isAutoRepeat(); };
    switch (event->type()) {
    case QEvent::MouseButtonPress: session_.beginGesture(); break;
    case QEvent::KeyPress:
        if (!repeated())
            session_.beginGesture();
        break;
    case QEvent::KeyRelease:
        if (!repeated())
            session_.endGesture();
        break;
    case QEvent::MouseButtonRelease:
    case QEvent::FocusOut: session_.endGesture(); break;
    default: break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace tetra
