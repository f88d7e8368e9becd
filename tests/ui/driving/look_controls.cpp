// SPDX-License-Identifier: GPL-3.0-or-later
// How the controls of the docks Rendering, View and Isovalues are driven, and what each changes (R19, R20, R21, R27).
#include "tests/ui/driving/driver.h"
#include "tests/ui/driving/scene_facts.h"
#include "ui/session/isovalue_defaults.h"

#include <QSettings>
#include <QToolButton>

namespace tetra {
namespace {

constexpr int chosenColour = 3;

Driver::Step inMode(const QString& mode, const QString& dock)
{
    return [=](DrivenWindow& window) {
        window.choose(mode);
        window.raise(dock);
        window.waitForPicture();
    };
}

/// Of the drop-down menus of colours.
Driver::Step choosingColour(const QString& button)
{
    return [button](DrivenWindow& window) {
        chooseInMenu(window.find<QToolButton>(button), QString("%1.%2").arg(button).arg(chosenColour));
    };
}

/// Steps a row of choices, whose last is followed by the one before it.
int nextChoice(int present, int choices)
{
    return present + 1 < choices ? present + 1 : present - 1;
}

Driver setting(const QString& id, const ParameterValue& value, const std::function<bool(const SceneFacts&)>& isSo,
               Driver::Step use = {})
{
    return redraw(
        "rendering.setting." + id,
        [id, value](Moment& moment, const DrivenWindow&) { moment.look.settings[id.toStdString()] = value; },
        [isSo](const DrivenWindow& window) { return window.settled() && isSo(factsOf(*window.viewport().scene())); },
        inMode("hybrid", "dock.rendering"), std::move(use));
}

/// A setting of the boundary, which is shown first.
Driver boundarySetting(const QString& id, const ParameterValue& value,
                       const std::function<bool(const SceneFacts&)>& isSo)
{
    Driver driver = setting(id, value, isSo);
    driver.prepare = [show = driver.prepare](DrivenWindow& window) {
        show(window);
        window.session().setSetting("boundary", std::string("translucent"));
        QCoreApplication::processEvents(); // what belongs to it is seen
        window.waitForPicture();
    };
    return driver;
}

Drivers renderingControls()
{
    const auto typeClipPlane = [](DrivenWindow& window) {
        auto& line = window.find<QWidget>("rendering.setting.clip");
        line.setFocus();
        QTest::keyClicks(&line, "1,0,0,4");
        QTest::keyClick(&line, Qt::Key_Return);
    };
    return {
        redraw(
            "rendering.mode", [](Moment& moment, const DrivenWindow&) { moment.look.mode = "volume"; },
            [](const DrivenWindow& window) {
                return window.settled() && factsOf(*window.viewport().scene()).hasVolume;
            },
            inDock("dock.rendering")),
        setting("shaded", true, [](const SceneFacts& scene) { return scene.shaded; }),
        setting("order", std::string("with-cell"), [](const SceneFacts& scene) { return scene.withCell; }),
        setting("outline", false, [](const SceneFacts& scene) { return scene.lines == 0; }),
        setting("boundary", std::string("translucent"),
                [](const SceneFacts& scene) { return scene.surfaces == 2 && scene.lastOpacity == 0.25F; }),
        boundarySetting("boundary-opacity", 0.35,
                        [](const SceneFacts& scene) { return scene.surfaces == 2 && scene.lastOpacity == 0.35F; }),
        boundarySetting("boundary-far-side", true,
                        [](const SceneFacts& scene) { return scene.surfaces == 2 && scene.backFacesOnly; }),
        setting(
            "clip", std::string("1,0,0,4"),
            [](const SceneFacts& scene) {
                return scene.clipPlanes == std::vector<std::array<double, 4>>{{1, 0, 0, 4}};
            },
            typeClipPlane),
        showing(
            "rendering.frameRate",
            [](const DrivenWindow&) { return QSettings().value("rendering/frameRate").toInt() == 1; },
            inDock("dock.rendering")),
    };
}

/// A number box of the camera.
template <class Reach> Driver ofCamera(const QString& name, Reach reach)
{
    return edit("view." + name, moves(reach, stepOfBox("view." + name)), inDock("dock.view"));
}

Driver lookingFrom(const QString& side, double azimuth, double elevation)
{
    const Driver::Change changes = [=](Moment& moment, const DrivenWindow&) {
        moment.camera.azimuth = azimuth;
        moment.camera.elevation = elevation;
    };
    return edit("view.from." + side, changes, [](DrivenWindow& window) {
        Camera camera = window.viewport().camera();
        camera.azimuth = 12;
        camera.elevation = 34;
        window.viewport().setCamera(camera);
        window.raise("dock.view");
    });
}

Drivers cameraControls()
{
    return {
        ofCamera("azimuth", [](Moment& moment) -> double& { return moment.camera.azimuth; }),
        ofCamera("elevation", [](Moment& moment) -> double& { return moment.camera.elevation; }),
        ofCamera("roll", [](Moment& moment) -> double& { return moment.camera.roll; }),
        ofCamera("distance", [](Moment& moment) -> double& { return moment.camera.distance; }),
        ofCamera("fieldOfView", [](Moment& moment) -> double& { return moment.camera.fieldOfView; }),
        ofCamera("target.x", [](Moment& moment) -> double& { return moment.camera.target.x(); }),
        ofCamera("target.y", [](Moment& moment) -> double& { return moment.camera.target.y(); }),
        ofCamera("target.z", [](Moment& moment) -> double& { return moment.camera.target.z(); }),
        edit(
            "view.up", [](Moment& moment, const DrivenWindow&) { moment.camera.up = UpAxis::MinusZ; },
            inDock("dock.view")),
        edit(
            "view.projection", [](Moment& moment, const DrivenWindow&) { moment.camera.perspective = false; },
            inDock("dock.view")),
        edit(
            "view.turning", [](Moment& moment, const DrivenWindow&) { moment.camera.trackball = true; },
            inDock("dock.view")),
        lookingFrom("front", 0, 0),
        lookingFrom("back", 180, 0),
        lookingFrom("left", 270, 0),
        lookingFrom("right", 90, 0),
        lookingFrom("top", 0, 90),
        lookingFrom("bottom", 0, -90),
        lookingFrom("corner", 30, 20),
        edit("view.fit", &fitView,
             [](DrivenWindow& window) {
                 window.press("viewport", Qt::Key_Plus);
                 window.raise("dock.view");
             }),
    };
}

Drivers annotationControls()
{
    Drivers drivers;
    for (std::size_t i = 0; i < annotationCount; ++i) {
        const QString name = QString("view.annotation.") + annotationNames[i];
        drivers.push_back(edit(
            name,
            [i](Moment& moment, const DrivenWindow&) {
                moment.annotations.places[i].shown = !moment.annotations.places[i].shown;
            },
            inDock("dock.view")));
        drivers.push_back(edit(
            name + ".corner",
            [i](Moment& moment, const DrivenWindow&) {
                Corner& corner = moment.annotations.places[i].corner;
                corner = static_cast<Corner>(nextChoice(static_cast<int>(corner), 4));
            },
            [i](DrivenWindow& window) {
                AnnotationState state = window.session().view().annotations();
                state.places[i].shown = true;
                window.session().setAnnotations(state);
                window.raise("dock.view");
            }));
    }
    return drivers;
}

Drivers viewControls()
{
    return {
        edit(
            "view.background",
            [](Moment& moment, const DrivenWindow&) { moment.background = paletteColour(chosenColour); },
            inDock("dock.view"), choosingColour("view.background")),
        edit(
            "view.usualBackground", [](Moment& moment, const DrivenWindow&) { moment.background.reset(); },
            [](DrivenWindow& window) {
                window.viewport().setBackground(Colour{1, 0, 0});
                window.raise("dock.view");
            }),
        opening("view.load", "cameraDialog", inDock("dock.view")),
        opening("view.save", "cameraSaveDialog", inDock("dock.view")),
    };
}

Drivers isovalueControls()
{
    const auto value = [](Moment& moment) -> double& { return moment.isovalues.front().value; };
    const auto opacity = [](Moment& moment) -> float& { return moment.isovalues.front().opacity; };
    // Percentages of whole numbers: one less than all.
    const AimFrom lessOpaque = [](const DrivenWindow&, double before) -> Aim { return {before - 0.01, 0.0051}; };
    const auto change = [](void (*changes)(Isovalue & isovalue)) {
        return [changes](Moment& moment, const DrivenWindow&) { changes(moment.isovalues.front()); };
    };
    const Driver::Step dock = inDock("dock.isovalues");
    return {
        edit("isovalue.0.visible", change([](Isovalue& isovalue) { isovalue.visible = false; }), dock),
        edit(
            "isovalue.0.remove",
            [](Moment& moment, const DrivenWindow&) { moment.isovalues.erase(moment.isovalues.begin()); }, dock),
        edit("isovalue.0.value.slider", moves(value, stepOfSlider(&rangeOf)), dock),
        edit("isovalue.0.value.box", moves(value, stepOfBox("isovalue.0.value.box")), dock),
        edit("isovalue.0.opacity.slider", moves(opacity, lessOpaque), dock),
        edit("isovalue.0.opacity.box", moves(opacity, lessOpaque), dock),
        edit("isovalue.0.colour", change([](Isovalue& isovalue) {
                 const auto [red, green, blue] = paletteColour(chosenColour);
                 isovalue.red = red;
                 isovalue.green = green;
                 isovalue.blue = blue;
             }),
             dock, choosingColour("isovalue.0.colour")),
        edit(
            "isovalues.add",
            [](Moment& moment, const DrivenWindow& window) {
                moment.isovalues.push_back(nextIsovalue(moment.isovalues, window.session().range()));
            },
            dock),
    };
}

} // namespace

Drivers lookControls()
{
    return allOf({renderingControls(), cameraControls(), annotationControls(), viewControls(), isovalueControls()});
}

} // namespace tetra
