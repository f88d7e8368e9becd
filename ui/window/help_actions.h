// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QMainWindow;

namespace tetra {

struct Actions;
class MessageBar;
class Workbench;

/// Makes the actions work that help to find one's way and suit the program to its user: the command palette, help on
/// controls and the manual, "What's this?", the language, reduced motion. Everything outlives the window's widgets.
void connectHelp(QMainWindow& window, const Actions& actions, Workbench& workbench, MessageBar& messages);

/// The first page of the manual that belongs to the program in `programFolder`, as installed or as built; empty if it
/// is not there.
QString manualPage(const QString& programFolder);

/// Shows a page of the manual in the user's web browser: "manual.html#focus" is one with a heading. Returns nothing, or
/// why that is impossible and what to do, for the user.
QString openManual(const QString& programFolder, const QString& place);

} // namespace tetra
