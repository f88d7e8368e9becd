// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <vector>

class QAction;
class QMainWindow;

namespace tetra {

class Workbench;

/// Something that can be done now, or why not.
struct PaletteCommand {
    QString name;           ///< object name of what it comes from
    QString text;           ///< with the menus that lead to it: "View: Look From: Front"
    qsizetype ownStart = 0; ///< where its own name begins in that
    QString spoken;         ///< the same by what is read out of it, where that is not what stands beside it; else empty
    QString explanation;    ///< what its tooltip says; empty if it has none of its own
    QString keys;           ///< its shortcut, for reading
    QString reason;         ///< why it cannot be done now; empty if it can
    std::function<void()> run;
    bool isSetting = false; ///< a control of a panel: it is brought into view, and gets the keys
};

/// All that the window's menus, panels and presets can do, in the order of the menus, and then what is set in the
/// panels. Settings of rendering modes other than the present one say which modes have them.
std::vector<PaletteCommand> paletteCommands(QMainWindow& window, Workbench& workbench);

/// Says what is to be done before the action can be used, for the time when it cannot.
void setNeed(QAction& action, const QString& need);

} // namespace tetra
