// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QObject>

class QAction;
class QActionGroup;
class QMenu;
class QToolBar;

namespace tetra {

/// The rendering modes in menu and tool bar, as actions of which one is checked, named action.mode.ID.
class ModeActions : public QObject {
    Q_OBJECT
public:
    /// Menu and tool bar outlive it.
    ModeActions(Workbench& workbench, QMenu& menu, QToolBar& toolBar, QObject* parent);

signals:
    /// By the user.
    void chosen(const QString& id);

private:
    void fill();
    void check();

    Workbench& workbench_;
    QMenu& menu_;
    QToolBar& toolBar_;
    QActionGroup* group_;
};

} // namespace tetra
