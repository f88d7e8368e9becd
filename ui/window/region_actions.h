// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <QAction>

class QMenu;
class QToolBar;

namespace tetra {

class Viewport;

/// The menu of focus, window and lens, and what is of use at hand in the tool bar. Object names are action.focusSphere,
/// .focusBox, .window, .lens and .focusToView.
class RegionActions : public QObject {
    Q_OBJECT
public:
    /// Owned by the menu; `viewport` says what the camera looks at.
    RegionActions(Session& session, Viewport& viewport, QMenu& menu, QToolBar& toolBar);

    /// Brings the focus to what the camera looks at.
    void focusToView();

signals:
    /// By the user, so that their settings should be seen.
    void focusSwitchedOn();
    void windowSwitchedOn();
    void lensSwitchedOn();

private:
    void chooseShape(FocusState::Shape shape, bool on);
    void chooseWindow(bool on);
    void chooseLens(bool on);
    void follow();

    Session& session_;
    Viewport& viewport_;
    QAction* sphere_;
    QAction* box_;
    QAction* toView_;
    QAction* window_;
    QAction* lens_;
};

} // namespace tetra
