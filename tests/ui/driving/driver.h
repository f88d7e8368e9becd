// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/driving/driven_window.h"

#include <functional>

namespace tetra {

/// How a test uses one command or one control, and how it sees that this did something.
struct Driver {
    using Step = std::function<void(DrivenWindow&)>;
    using Condition = std::function<bool(const DrivenWindow&)>;

    QString name;       ///< object name; with a * at its end of all that begin so
    Condition done;     ///< not before, and soon after
    Step prepare{};     ///< what it needs
    Step use{};         ///< of controls; none: as their kind is used by keys
    bool isEdit = true; ///< one step more of the undo stack, and undo brings back what was there

    bool drives(const QString& other) const;
};
using Drivers = std::vector<Driver>;

/// One that is no edit.
Driver showing(const QString& name, Driver::Condition done, Driver::Step prepare = {}, Driver::Step use = {});
/// It opens a dialog or another widget of this name.
Driver opening(const QString& name, const QString& widget, Driver::Step prepare = {});

/// Whether a part of the view is another one than before.
template <class Part> Driver::Condition changes(Part ViewValue::*part)
{
    return [part](const DrivenWindow& window) { return window.now().*part != window.before().*part; };
}

Drivers allOf(std::initializer_list<Drivers> parts);

/// The window's actions: menus, tool bar, docks and the editor.
Drivers fileCommands();
Drivers viewCommands();
Drivers regionAndHelpCommands();
Drivers transferCommands();
Drivers colourCommands();
Drivers pickCommands();

/// The controls of the docks.
Drivers accuracyControls(); ///< accuracy and statistics
Drivers lookControls();     ///< rendering, view and isovalues
Drivers transferControls();
Drivers regionControls(); ///< focus and region
Drivers animationControls();
Drivers buildControls();

/// Prepares a panel: brings its dock to the front.
Driver::Step inDock(const QString& dock);

/// Does what somebody does by keys with a control of this kind: steps a number, checks a box, takes another entry.
void useByKeys(QWidget& control);

/// Uses it in a window as it is at first, and says what is wrong; empty if all is well. `use`: does it.
QString drive(DrivenWindow& window, const Driver& driver, const std::function<void()>& use);

} // namespace tetra
