// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMainWindow;

namespace tetra {

struct Actions;
class MessageBar;
class Session;

/// Makes the actions work that help to find one's way and suit the program to its user: the command palette, "What's
/// this?", the language, reduced motion. Everything outlives the window's widgets.
void connectHelp(QMainWindow& window, const Actions& actions, Session& session, MessageBar& messages);

} // namespace tetra
