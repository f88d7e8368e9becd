// SPDX-License-Identifier: GPL-3.0-or-later
// How the controls of the docks Rendering, View and Isovalues are driven.
#include "tests/ui/driving/driver.h"

#include <QSettings>
#include <QToolButton>

namespace tetra {
namespace {

Driver::Step inMode(const QString& mode, const QString& dock)
{
    return [=](DrivenWindow& window) {
        window.choose(mode);
        window.raise(dock);
    };
}

/// Of the drop-down menus of colours.
Driver::Step choosingColour(const QString& button)
{
    return [button](DrivenWindow& window) { chooseInMenu(window.find<QToolButton>(button), button + ".3"); };
}

Driver setting(const QString& id, Driver::Step use = {})
{
    return {"rendering.setting." + id,
            [id](const DrivenWindow& window) {
                return window.session().view().appearance.settings.contains(id.toStdString()) && window.settled();
            },
            inMode("hybrid", "dock.rendering"), std::move(use)};
}

/// A setting of the boundary, which is shown first.
Driver boundarySetting(const QString& id)
{
    Driver driver = setting(id);
    driver.prepare = [show = driver.prepare](DrivenWindow& window) {
        show(window);
        window.session().setSetting("boundary", std::string("translucent"));
        QCoreApplication::processEvents(); // what belongs to it is seen
    };
    return driver;
}

Drivers renderingControls()
{
    return {
        {"rendering.mode", changes(&ViewValue::appearance), inDock("dock.rendering")},
        setting("shaded"),
        setting("order"),
        setting("outline"),
        setting("boundary"),
        boundarySetting("boundary-opacity"),
        boundarySetting("boundary-far-side"),
        setting("clip",
                [](DrivenWindow& window) {
                    auto& line = window.find<QWidget>("rendering.setting.clip");
                    line.setFocus();
                    QTest::keyClicks(&line, "1,0,0,4");
                    QTest::keyClick(&line, Qt::Key_Return);
                }),
        showing(
            "rendering.frameRate",
            [](const DrivenWindow&) { return QSettings().value("rendering/frameRate").toInt() == 1; },
            inDock("dock.rendering")),
    };
}

Driver ofCamera(const QString& name, Driver::Step prepare = inDock("dock.view"))
{
    return {"view." + name, changes(&ViewValue::camera), std::move(prepare)};
}

Drivers cameraControls()
{
    Drivers drivers;
    for (const char* name :
         {"azimuth", "elevation", "roll", "up", "distance", "fieldOfView", "projection", "turning", "target.x",
          "target.y", "target.z", "from.front", "from.back", "from.left", "from.right", "from.top", "from.bottom"})
        drivers.push_back(ofCamera(name));
    drivers.push_back(ofCamera("from.corner", [](DrivenWindow& window) {
        window.trigger("action.view.top");
        window.raise("dock.view");
    }));
    drivers.push_back(ofCamera("fit", [](DrivenWindow& window) {
        window.press("viewport", Qt::Key_Plus);
        window.raise("dock.view");
    }));
    return drivers;
}

Drivers annotationControls()
{
    Drivers drivers;
    for (std::size_t i = 0; i < annotationCount; ++i) {
        const QString name = QString("view.annotation.") + annotationNames[i];
        drivers.push_back({name, changes(&ViewValue::annotations), inDock("dock.view")});
        drivers.push_back({name + ".corner", changes(&ViewValue::annotations), [i](DrivenWindow& window) {
                               AnnotationState state = window.session().view().annotations;
                               state.places[i].shown = true;
                               window.session().setAnnotations(state);
                               window.raise("dock.view");
                           }});
    }
    return drivers;
}

Drivers viewControls()
{
    return {
        {"view.background", changes(&ViewValue::background), inDock("dock.view"), choosingColour("view.background")},
        {"view.usualBackground", changes(&ViewValue::background),
         [](DrivenWindow& window) {
             window.session().setBackground(Colour{1, 0, 0});
             window.raise("dock.view");
         }},
        opening("view.load", "cameraDialog", inDock("dock.view")),
        opening("view.save", "cameraSaveDialog", inDock("dock.view")),
    };
}

Drivers isovalueControls()
{
    Drivers drivers;
    for (const char* name : {"visible", "remove", "value.slider", "value.box", "opacity.slider", "opacity.box"})
        drivers.push_back({QString("isovalue.0.") + name, changes(&ViewValue::isovalues), inDock("dock.isovalues")});
    drivers.push_back({"isovalue.0.colour", changes(&ViewValue::isovalues), inDock("dock.isovalues"),
                       choosingColour("isovalue.0.colour")});
    drivers.push_back({"isovalues.add", changes(&ViewValue::isovalues), inDock("dock.isovalues")});
    return drivers;
}

} // namespace

Drivers lookControls()
{
    return allOf({renderingControls(), cameraControls(), annotationControls(), viewControls(), isovalueControls()});
}

} // namespace tetra
