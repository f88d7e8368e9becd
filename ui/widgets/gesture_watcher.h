// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <QObject>

namespace tetra {

/// Makes one undo step of what happens between pressing and releasing a mouse button or a key on a widget: one for a
/// drag, one for a key that is held. The watched widget owns it.
class GestureWatcher : public QObject {
    Q_OBJECT
public:
    GestureWatcher(QWidget* watched, Session& session);
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    Session& session_;
};

} // namespace tetra
