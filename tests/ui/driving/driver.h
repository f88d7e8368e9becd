// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/driving/driven_window.h"

#include <cmath>
#include <functional>
#include <type_traits>

namespace tetra {

/// How a test uses one command or one control, and what that changes: exactly.
struct Driver {
    using Step = std::function<void(DrivenWindow&)>;
    using Condition = std::function<bool(const DrivenWindow&)>;
    /// Makes of the view before the view after: what it leaves alone must not change.
    using Change = std::function<void(ViewValue& view, const DrivenWindow& window)>;

    QString name;              ///< object name; with a * at its end of all that begin so
    Change changes{};          ///< none: the view stays as it is
    Condition shows{};         ///< what is seen besides: not before, and soon after
    Step prepare{};            ///< what it needs
    Step use{};                ///< none: a command is triggered, a control used by keys as its kind is
    int steps = 0;             ///< by so many goes the undo stack on
    bool opensAnother = false; ///< another file or none: then nothing is said of the view

    bool drives(const QString& other) const;
};
using Drivers = std::vector<Driver>;

/// One step of the undo stack that changes nothing but this.
Driver edit(const QString& name, Driver::Change changes, Driver::Step prepare = {}, Driver::Step use = {});
/// The same, and the picture's scene is another one then.
Driver redraw(const QString& name, Driver::Change changes, Driver::Condition shows, Driver::Step prepare = {},
              Driver::Step use = {});
/// One that changes nothing of what can be undone.
Driver showing(const QString& name, Driver::Condition shows, Driver::Step prepare = {}, Driver::Step use = {});
/// It opens a dialog or another widget of this name.
Driver opening(const QString& name, const QString& widget, Driver::Step prepare = {});

/// A number that a control brings somewhere, which it rounds as it shows numbers.
struct Aim {
    double value = 0;
    double tolerance = 0;
};
/// Of the number before.
using AimFrom = std::function<Aim(const DrivenWindow& window, double before)>;

/// The arrow key on a number box of this name: `step` away from the end that it is at.
using Distance = std::function<double(const DrivenWindow& window)>;
AimFrom stepOfBox(const QString& box, const Distance& step);
/// What a box or a slider goes over.
using Ends = std::function<TransferLimits(const DrivenWindow& window)>;
/// The step of most boxes, a hundredth of it.
Distance hundredthOf(const Ends& ends);
/// The arrow key on a slider: a hundredth of it.
AimFrom stepOfSlider(const Ends& ends);

/// The number of a view that `reach` finds goes where `aim` says, and nothing else does.
template <class Reach> Driver::Change moves(Reach reach, AimFrom aim)
{
    return [reach, aim](ViewValue& view, const DrivenWindow& window) {
        using Number = std::remove_reference_t<decltype(reach(view))>;
        ViewValue now = window.now();
        const auto [value, tolerance] = aim(window, static_cast<double>(reach(view)));
        const bool isThere = std::abs(static_cast<double>(reach(now)) - value) <= tolerance;
        reach(view) = isThere ? reach(now) : static_cast<Number>(value);
    };
}

/// The transfer function becomes `edited` of it, but for rounding far below what can be seen.
using TransferEdit = std::function<TransferFunction(const TransferFunction& function, const DrivenWindow& window)>;
Driver::Change transfer(const TransferEdit& edited);

/// The values of the model.
TransferLimits rangeOf(const DrivenWindow& window);
/// Changes: what there is to see is seen whole, or all of the domain, from the same side.
void fitView(ViewValue& view, const DrivenWindow& window);
void fitWholeView(ViewValue& view, const DrivenWindow& window);

Drivers allOf(std::initializer_list<Drivers> parts);

/// The window's actions: menus, tool bar, docks and the editor.
Drivers fileCommands();
Drivers viewCommands();
Drivers regionAndHelpCommands();
Drivers transferCommands();
Drivers colourCommands();
Drivers pickCommands();
Drivers toolCommands();

/// The controls of the docks.
Drivers accuracyControls(); ///< accuracy and statistics
Drivers lookControls();     ///< rendering, view and isovalues
Drivers transferControls();
Drivers regionControls(); ///< focus and region
Drivers animationControls();
Drivers buildControls();
Drivers toolControls(); ///< of the tools of this build

/// Prepares a panel: brings its dock to the front.
Driver::Step inDock(const QString& dock);

/// Of the menus of colours, by its place there.
inline constexpr int paletteSize = 16;
Colour paletteColour(int index);

/// Does what somebody does by keys with a control of this kind: steps a number, checks a box, takes another entry.
void useByKeys(QWidget& control);

/// Uses it in a window as it is at first, and says what is wrong; empty if all is well. `use`: does it, if the driver
/// does not say how.
QString drive(DrivenWindow& window, const Driver& driver, const std::function<void()>& use);

} // namespace tetra
