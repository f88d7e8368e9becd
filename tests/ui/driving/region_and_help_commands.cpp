// SPDX-License-Identifier: GPL-3.0-or-later
// How the actions of the menus Region and Help are driven.
#include "tests/ui/driving/driver.h"
#include "tests/waiting.h"

#include <QDesktopServices>
#include <QLabel>
#include <QWhatsThis>

namespace tetra {
namespace {

Driver::Change toShape(FocusState::Shape shape)
{
    return [shape](ViewValue& view, const DrivenWindow&) { view.query.focus.shape = shape; };
}

/// The focus is somewhere else than the camera looks at.
void switchFocusOn(DrivenWindow& window)
{
    FocusState focus = window.session().view().query.focus;
    focus.shape = FocusState::Shape::Box;
    focus.centre *= 0.5;
    window.session().setFocus(focus);
}

Drivers regionCommands()
{
    return {
        edit("action.focusSphere", toShape(FocusState::Shape::Sphere)),
        edit("action.focusBox", toShape(FocusState::Shape::Box)),
        edit(
            "action.focusToView",
            [](ViewValue& view, const DrivenWindow&) { view.query.focus.centre = view.camera.target; }, &switchFocusOn),
        edit("action.lens", [](ViewValue& view, const DrivenWindow&) { view.lens.shape = LensState::Shape::Circle; }),
        edit("action.window", [](ViewValue& view, const DrivenWindow&) { view.query.window.enabled = true; }),
    };
}

} // namespace

Drivers regionAndHelpCommands()
{
    const Drivers help{
        // A page in the browser; where there is no manual yet the window says so.
        // The message takes height from the picture, which a camera that nobody has moved then fits.
        {"action.manual", fitView, [](const DrivenWindow& window) { return !window.messages().isEmpty(); }},
        showing(
            "action.help",
            [](const DrivenWindow& window) {
                return window.isOpen("help") &&
                       window.find<QLabel>("help.text").text() == window.find<QWidget>("accuracy.byBudget").toolTip();
            },
            [](DrivenWindow& window) {
                window.window.activateWindow();
                if (!QTest::qWaitForWindowActive(&window.window, patiently(5000)))
                    qFatal("the window does not get the keys");
                window.find<QWidget>("accuracy.byBudget").setFocus();
            }),
        showing("action.whatsThis", [](const DrivenWindow&) { return QWhatsThis::inWhatsThisMode(); }),
        opening("action.plugins", "pluginWindow"),
        opening("action.about", "aboutBox"),
    };
    return allOf({regionCommands(), help});
}

} // namespace tetra
