// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

#include <QList>
#include <QObject>

class QAction;
class QActionGroup;
class QMenu;

namespace tetra {

class Session;

/// How the picture is turned upright: which axis points up, roll, and whether a drag turns a trackball. Actions named
/// action.up.AXIS and so on, each one step to undo.
class OrientationActions : public QObject {
    Q_OBJECT
public:
    /// Both outlive it.
    OrientationActions(Session& session, QMenu& menu);

private:
    void addUpAxes(QMenu& menu);
    void follow();

    Session& session_;
    QActionGroup* upAxes_; ///< in the order of UpAxis
    QAction* flip_;
    QAction* rollRight_;
    QAction* rollLeft_;
    QAction* level_;
    QAction* trackball_;
};

} // namespace tetra
