// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

namespace tetra {

/// Makes one undo step of what happens between pressing and releasing a mouse button or a key on a widget: one for a
/// drag, one for a key that is held. The watched widget owns it.
class GestureWatcher : public QObject {
    Q_OBJECT
public:
    GestureWatcher(QWidget* watched, std::function<void()> begin, std::function<void()> end);
    /// Of whatever makes one undo step of what lies between beginGesture() and endGesture(); it outlives the widget.
    template <class Undoable> GestureWatcher(QWidget* watched, Undoable& undoable)
        : GestureWatcher(
              watched, [&undoable] { undoable.beginGesture(); }, [&undoable] { undoable.endGesture(); })
    {
    }
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::function<void()> begin_;
    std::function<void()> end_;
};

} // namespace tetra
