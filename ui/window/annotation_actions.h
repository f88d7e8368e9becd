// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <array>

class QAction;
class QMenu;

namespace tetra {

/// Actions that switch the annotations on and off, action.annotation.NAME.
class AnnotationActions : public QObject {
    Q_OBJECT
public:
    /// Puts them into `menu`, which owns them.
    AnnotationActions(Session& session, QMenu& menu, QObject* parent);

private:
    void follow();

    Session& session_;
    QMenu& menu_;
    std::array<QAction*, annotationCount> actions_{};
};

} // namespace tetra
