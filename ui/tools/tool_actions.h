// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool_desk.h"

#include <QObject>

class QAction;
class QMenu;
class QToolBar;

namespace tetra {

/// The tools of plugins in menu and tool bar, as actions of which at most one is checked, named action.tool.ID.
class ToolActions : public QObject {
    Q_OBJECT
public:
    /// Owned by the menu of a window, which the others outlive. A key that another action of the menu's window has is
    /// not taken.
    ToolActions(ToolDesk& desk, Workbench& workbench, QMenu& menu, QToolBar& toolBar);

    const std::vector<QAction*>& actions() const noexcept { return actions_; }

signals:
    /// By the user, so that its panel should be seen.
    void switchedOn();

private:
    void follow();

    ToolDesk& desk_;
    Session& session_;
    std::vector<QAction*> actions_; ///< in the order of the desk's tools
};

} // namespace tetra
