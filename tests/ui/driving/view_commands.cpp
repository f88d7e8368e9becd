// SPDX-License-Identifier: GPL-3.0-or-later
// How the actions of the menu View are driven.
#include "tests/ui/driving/driver.h"
#include "ui/session/language.h"
#include "ui/widgets/motion.h"

#include <QDockWidget>
#include <QToolBar>

namespace tetra {
namespace {

Driver::Condition isSeenFrom(double azimuth, double elevation)
{
    return [=](const DrivenWindow& window) {
        const Camera& camera = window.viewport().camera();
        return camera.azimuth == azimuth && camera.elevation == elevation;
    };
}

Driver upAxisCommand(const QString& name, UpAxis up)
{
    return {"action.up." + name, [up](const DrivenWindow& window) { return window.viewport().camera().up == up; },
            [](DrivenWindow& window) { window.viewport().setCamera(upright(window.viewport().camera(), UpAxis::X)); }};
}

Drivers orientationCommands()
{
    Drivers drivers{upAxisCommand("minusX", UpAxis::MinusX), upAxisCommand("y", UpAxis::Y),
                    upAxisCommand("minusY", UpAxis::MinusY), upAxisCommand("z", UpAxis::Z),
                    upAxisCommand("minusZ", UpAxis::MinusZ)};
    drivers.push_back(
        {"action.up.x", [](const DrivenWindow& window) { return window.viewport().camera().up == UpAxis::X; }});
    drivers.push_back(
        {"action.flip", [](const DrivenWindow& window) { return window.viewport().camera().up == UpAxis::MinusZ; }});
    for (const auto& [name, roll] : {std::pair("rollRight", 90.0), std::pair("rollLeft", -90.0)})
        drivers.push_back({QString("action.") + name,
                           [roll](const DrivenWindow& window) { return window.viewport().camera().roll == roll; }});
    drivers.push_back({"action.level", [](const DrivenWindow& window) { return window.viewport().camera().roll == 0; },
                       [](DrivenWindow& window) { window.trigger("action.rollLeft"); }});
    drivers.push_back(
        {"action.trackball", [](const DrivenWindow& window) { return window.viewport().camera().trackball; }});
    return drivers;
}

Drivers cameraCommands()
{
    return {
        {"action.fit", changes(&ViewValue::camera),
         [](DrivenWindow& window) { window.press("viewport", Qt::Key_Plus); }},
        {"action.view.front", isSeenFrom(0, 0)},
        {"action.view.back", isSeenFrom(180, 0)},
        {"action.view.left", isSeenFrom(270, 0)},
        {"action.view.right", isSeenFrom(90, 0)},
        {"action.view.top", isSeenFrom(0, 90)},
        {"action.view.bottom", isSeenFrom(0, -90)},
        {"action.view.corner", isSeenFrom(30, 20), [](DrivenWindow& window) { window.trigger("action.view.top"); }},
        {"action.resetView",
         [](const DrivenWindow& window) {
             return window.session().view().isovalues.size() == 1 && !window.session().view().background;
         },
         [](DrivenWindow& window) {
             window.session().addIsovalue();
             window.session().setBackground(Colour{1, 0, 0});
         }},
        {"action.perspective", [](const DrivenWindow& window) { return !window.viewport().camera().perspective; }},
    };
}

Driver mode(const QString& id, const QString& before)
{
    return {"action.mode." + id,
            [id](const DrivenWindow& window) {
                return window.session().view().appearance.mode == id.toStdString() && window.settled();
            },
            [before](DrivenWindow& window) { window.choose(before); }};
}

Drivers modeCommands()
{
    return {mode("isosurface", "volume"), mode("volume", "hybrid"), mode("hybrid", "focus"),
            mode("focus", "isosurface")};
}

Drivers annotationCommands()
{
    Drivers drivers;
    for (const char* name : annotationNames)
        drivers.push_back({QString("action.annotation.") + name, changes(&ViewValue::annotations)});
    return drivers;
}

Drivers dockCommands()
{
    Drivers drivers;
    for (const QString name : {"build", "accuracy", "rendering", "view", "statistics", "isovalues", "transfer", "focus",
                               "region", "animation"})
        drivers.push_back(showing(
            "action.dock." + name, [name](const DrivenWindow& window) { return window.isOpen("dock." + name); },
            [name](DrivenWindow& window) { window.find<QDockWidget>("dock." + name).hide(); }));
    return drivers;
}

Drivers languageCommands()
{
    Drivers drivers;
    for (const QString code : {"en", "de", "it"})
        drivers.push_back(showing(
            "action.language." + code, [code](const DrivenWindow&) { return chosenLanguage() == code; },
            [](DrivenWindow& window) { window.trigger("action.language.system"); }));
    drivers.push_back(showing(
        "action.language.system", [](const DrivenWindow&) { return chosenLanguage().isEmpty(); },
        [](DrivenWindow& window) { window.trigger("action.language.en"); }));
    return drivers;
}

} // namespace

Drivers viewCommands()
{
    const Drivers others{
        showing("action.toolBar",
                [](const DrivenWindow& window) { return !window.find<QToolBar>("toolBar").isVisible(); }),
        showing(
            "action.resetLayout", [](const DrivenWindow& window) { return window.isOpen("dock.accuracy"); },
            [](DrivenWindow& window) { window.find<QDockWidget>("dock.accuracy").hide(); }),
        showing("action.fullScreen", [](const DrivenWindow& window) { return window.window.isFullScreen(); }),
        showing("action.reducedMotion", [](const DrivenWindow&) { return motionReduced(); }),
    };
    return allOf({cameraCommands(), orientationCommands(), modeCommands(), annotationCommands(), dockCommands(),
                  languageCommands(), others});
}

} // namespace tetra
