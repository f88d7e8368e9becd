// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>

class QMainWindow;
class QMenu;
class QToolBar;
class QUndoStack;

namespace tetra {

/// The actions of the window's menus, owned by the window. Object names are "action." and the member's name.
struct Actions {
    QAction* open = nullptr;
    QAction* openWithOptions = nullptr;
    QAction* openAddress = nullptr;
    QAction* modelCache = nullptr;
    QAction* close = nullptr;
    QAction* saveSession = nullptr;
    QAction* saveSessionAs = nullptr;
    QAction* applyLook = nullptr;
    QAction* savePicture = nullptr;
    QAction* copyPicture = nullptr;
    QAction* saveFilm = nullptr;
    QAction* saveMesh = nullptr;
    QAction* savePacked = nullptr;
    QAction* saveSurfaces = nullptr;
    QAction* saveSolids = nullptr;
    QAction* saveStatistics = nullptr;
    QAction* quit = nullptr;
    QAction* undo = nullptr;
    QAction* redo = nullptr;
    QAction* addIsovalue = nullptr;
    QAction* palette = nullptr;
    QAction* fit = nullptr;
    QAction* fitWhole = nullptr;
    QAction* perspective = nullptr;
    QAction* resetView = nullptr;
    QList<QAction*> namedViews; ///< in the order of NamedView
    QAction* fullScreen = nullptr;
    QAction* resetLayout = nullptr;
    QAction* manual = nullptr;
    QAction* reducedMotion = nullptr;
    QAction* help = nullptr;
    QAction* whatsThis = nullptr;
    QAction* plugins = nullptr;
    QAction* about = nullptr;
    QMenu* recent = nullptr;
    QMenu* samples = nullptr;     ///< one action each, with the sample's name as its data
    QMenu* lookFrom = nullptr;    ///< namedViews
    QMenu* orientation = nullptr; ///< for those of OrientationActions
    QMenu* bookmarks = nullptr;   ///< for those of BookmarkActions
    QMenu* languages = nullptr;
    QMenu* panels = nullptr;      ///< for the docks' own actions
    QMenu* modes = nullptr;       ///< for those of ModeActions
    QMenu* annotations = nullptr; ///< for those of AnnotationActions
    QMenu* region = nullptr;      ///< for those of RegionActions
    QMenu* tools = nullptr;       ///< for those of ToolActions
    QMenu* picked = nullptr;      ///< for those of PickActions
    QToolBar* toolBar = nullptr;
};

/// Adds an action called "action.NAME", whose tool tip ends with its shortcut.
QAction* addAction(QMenu& menu, const char* name, const QString& text, const QKeySequence& shortcut,
                   const QString& toolTip);

/// Makes the actions, the menus and the tool bar.
Actions makeActions(QMainWindow& window, QUndoStack& undoStack);

} // namespace tetra
