// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <vector>

class QDockWidget;
class QMainWindow;
class QMenu;

namespace tetra {

class AnimationPanel;
class BuildPanel;
class FocusPanel;
class RenderingPanel;
class StatisticsPanel;
class ToolDesk;
class ValuePick;
class Viewport;

/// The window's panels in docks, named dock.NAME; the actions that show and hide them are action.dock.NAME. Owned by
/// the window.
struct Docks {
    QDockWidget* build = nullptr;
    QDockWidget* accuracy = nullptr;
    QDockWidget* rendering = nullptr;
    QDockWidget* view = nullptr;
    QDockWidget* statistics = nullptr;
    QDockWidget* isovalues = nullptr;
    QDockWidget* transfer = nullptr; ///< one of the editors
    QDockWidget* focus = nullptr;
    QDockWidget* region = nullptr;
    QDockWidget* animation = nullptr;    ///< hidden at first
    QDockWidget* tools = nullptr;        ///< likewise, until a tool is chosen
    std::vector<QDockWidget*> editors{}; ///< of the editor plugins
    AnimationPanel* animationPanel = nullptr;
    BuildPanel* buildPanel = nullptr;
    FocusPanel* focusPanel = nullptr;
    RenderingPanel* renderingPanel = nullptr;
    StatisticsPanel* statisticsPanel = nullptr;
};

/// Makes them and puts their actions into `menu`. All others outlive the window's widgets.
Docks makeDocks(QMainWindow& window, QMenu& menu, Workbench& workbench, Viewport& viewport, ValuePick& pick,
                ToolDesk& tools);

/// Puts all docks where they are at first; the one for builds is seen only with a dataset to build of. The window keeps
/// its size. On a small screen all are tabs of one place.
void layOutDocks(QMainWindow& window, const Docks& docks, bool showBuild);

/// Brings a dock to the front, also one that was closed.
void raiseDock(QDockWidget& dock);

} // namespace tetra
