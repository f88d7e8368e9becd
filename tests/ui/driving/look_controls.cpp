// SPDX-License-Identifier: GPL-3.0-or-later
// How the controls of the docks Rendering, View and Isovalues are driven, and what each changes (R19, R20, R21, R27).
#include "core/view/appearance.h"
#include "tests/ui/driving/driver.h"
#include "tests/ui/driving/scene_facts.h"

#include <tan/view.h>

#include <QComboBox>
#include <QLineEdit>
#include <QSettings>
#include <QSpinBox>
#include <QToolButton>

#include <cmath>
#include <string>

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
        [id, value](ViewValue& view, const DrivenWindow&) { view.appearance.settings[id.toStdString()] = value; },
        [isSo](const DrivenWindow& window) { return window.settled() && isSo(factsOf(*window.viewport().scene())); },
        inMode("hybrid", "dock.rendering"), std::move(use));
}

/// A setting of the boundary, which is shown first, in this way.
Driver boundarySetting(const QString& id, const ParameterValue& value,
                       const std::function<bool(const SceneFacts&)>& isSo, const std::string& shown = "translucent")
{
    Driver driver = setting(id, value, isSo);
    driver.prepare = [show = driver.prepare, shown](DrivenWindow& window) {
        show(window);
        window.session().setSetting("boundary", shown);
        QCoreApplication::processEvents(); // what belongs to it is seen
        window.waitForPicture();
    };
    return driver;
}

/// What the blend of two resolutions shows.
Driver shows()
{
    Driver driver = setting("shows", std::string("surfaces"),
                            [](const SceneFacts& scene) { return !scene.hasVolume && scene.surfaces == 1; });
    driver.prepare = inMode("focus", "dock.rendering");
    return driver;
}

/// A setting of a mode of its own.
Driver settingOf(const QString& mode, const QString& id, const ParameterValue& value,
                 const std::function<bool(const SceneFacts&)>& isSo, Driver::Step use = {})
{
    Driver driver = setting(id, value, isSo, std::move(use));
    driver.prepare = inMode(mode, "dock.rendering");
    return driver;
}

Drivers sliceSettings()
{
    const auto isOne = [](char axis, const std::string& place) {
        return [label = std::string("slice ") + axis + "=" + place](const SceneFacts& scene) {
            return scene.saved.size() == 1 && scene.saved.front().starts_with(label);
        };
    };
    const auto typePlane = [](DrivenWindow& window) {
        auto& line = window.find<QWidget>("rendering.setting.slices");
        line.setFocus();
        QTest::keyClicks(&line, "z=4");
        QTest::keyClick(&line, Qt::Key_Return);
    };
    return {settingOf("slice", "slice-axis", std::string("x"), isOne('x', "")),
            settingOf("slice", "slice-place", 51.0,
                      [](const SceneFacts& scene) {
                          return scene.saved.size() == 3 && std::abs(scene.firstShare - 0.51) < 1e-5;
                      }),
            settingOf("slice", "slices", std::string("z=4"), isOne('z', "4"), typePlane),
            settingOf("slice", "slice-opacity", std::string("function"),
                      [](const SceneFacts& scene) { return scene.saved.size() > 3; }),
            settingOf("slice", "isosurfaces", true, [](const SceneFacts& scene) { return scene.surfaces == 4; })};
}

Driver projection()
{
    return settingOf("projection", "projection", std::string("minimum"), [](const SceneFacts& scene) {
        return scene.rayShader.find("2.0 - 2.0 * opacity") != std::string::npos;
    });
}

/// What is drawn then: the entry of this number.
void whileMoving(DrivenWindow& window, int kind)
{
    window.raise("dock.rendering");
    window.find<QComboBox>("rendering.moving").setCurrentIndex(kind);
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
            "rendering.mode", [](ViewValue& view, const DrivenWindow&) { view.appearance.mode = "volume"; },
            [](const DrivenWindow& window) {
                return window.settled() && factsOf(*window.viewport().scene()).hasVolume;
            },
            inDock("dock.rendering")),
        setting("shaded", false, [](const SceneFacts& scene) { return !scene.shaded; }),
        setting("full-gradient", 0.1, [](const SceneFacts& scene) { return scene.fullGradient == 0.1; }),
        setting("order", std::string("with-cell"), [](const SceneFacts& scene) { return scene.withCell; }),
        setting("show", std::string("data"), [](const SceneFacts& scene) { return scene.hasSamples; }),
        shows(),
        projection(),
        setting("outline", true, [](const SceneFacts& scene) { return scene.lines == 1; }),
        setting("boundary", std::string("translucent"),
                [](const SceneFacts& scene) { return scene.surfaces == 2 && scene.lastOpacity == 0.25F; }),
        boundarySetting("boundary-opacity", 0.35,
                        [](const SceneFacts& scene) { return scene.surfaces == 2 && scene.lastOpacity == 0.35F; }),
        boundarySetting("boundary-far-side", true,
                        [](const SceneFacts& scene) { return scene.surfaces == 2 && scene.backFacesOnly; }),
        boundarySetting(
            "lit", true, [](const SceneFacts& scene) { return scene.surfaces == 2 && scene.lit; }, "values"),
        setting(
            "clip", std::string("1,0,0,4"),
            [](const SceneFacts& scene) {
                return scene.clipPlanes == std::vector<std::array<double, 4>>{{1, 0, 0, 4}};
            },
            typeClipPlane),
        showing(
            "rendering.frameRate",
            [](const DrivenWindow& window) {
                return QSettings().value("rendering/frameRate").toInt() == 1 && window.viewport().frameRate() == 1;
            },
            [](DrivenWindow& window) {
                whileMoving(window, 0);
                window.find<QSpinBox>("rendering.frameRate").setValue(0); // automatic
                if (window.viewport().frameRate() != window.viewport().usualFrameRate())
                    qFatal("the usual frame rate is not held");
            }),
        showing(
            "rendering.moving",
            [](const DrivenWindow& window) {
                return QSettings().value("rendering/moving").toString() == "error" &&
                       window.find<QWidget>("rendering.movingError").isVisible();
            },
            [](DrivenWindow& window) { whileMoving(window, 0); }),
        showing(
            "rendering.movingError",
            [](const DrivenWindow&) { return QSettings().value("rendering/movingError").toDouble() == 5; },
            [](DrivenWindow& window) {
                whileMoving(window, 1);
                window.find<QDoubleSpinBox>("rendering.movingError").setValue(4);
            }),
        showing(
            "rendering.movingShare",
            [](const DrivenWindow&) { return QSettings().value("rendering/movingShare").toInt() == 11; },
            [](DrivenWindow& window) {
                whileMoving(window, 2);
                window.find<QSpinBox>("rendering.movingShare").setValue(10);
            }),
        showing(
            "rendering.idleTime",
            [](const DrivenWindow& window) {
                return QSettings().value("rendering/idleTime").toInt() == 200 &&
                       window.viewport().idleTime() == std::chrono::milliseconds(200);
            },
            [](DrivenWindow& window) {
                whileMoving(window, 0);
                window.find<QSpinBox>("rendering.idleTime").setValue(150);
            }),
    };
}

/// A number box of the camera.
template <class Reach> Driver ofCamera(const QString& name, const Distance& step, Reach reach)
{
    return edit("view." + name, moves(reach, stepOfBox("view." + name, step)), inDock("dock.view"));
}

double oneDegree(const DrivenWindow&)
{
    return 1;
}

/// Nearer or farther in about twenty steps.
double partOfDiagonal(const DrivenWindow& window)
{
    return window.session().model()->diagonal() / 20;
}

/// A target may be as far from the middle as the diagonal is long, to both sides.
TransferLimits twoDiagonals(const DrivenWindow& window)
{
    return {0, 2 * window.session().model()->diagonal()};
}

Driver lookingFrom(const QString& side, double azimuth, double elevation)
{
    const Driver::Change changes = [=](ViewValue& view, const DrivenWindow&) {
        view.camera.azimuth = azimuth;
        view.camera.elevation = elevation;
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
    const Distance targetStep = hundredthOf(&twoDiagonals);
    return {
        ofCamera("azimuth", &oneDegree, [](ViewValue& view) -> double& { return view.camera.azimuth; }),
        ofCamera("elevation", &oneDegree, [](ViewValue& view) -> double& { return view.camera.elevation; }),
        ofCamera("roll", &oneDegree, [](ViewValue& view) -> double& { return view.camera.roll; }),
        ofCamera("distance", &partOfDiagonal, [](ViewValue& view) -> double& { return view.camera.distance; }),
        ofCamera("fieldOfView", &oneDegree, [](ViewValue& view) -> double& { return view.camera.fieldOfView; }),
        ofCamera("target.x", targetStep, [](ViewValue& view) -> double& { return view.camera.target.x(); }),
        ofCamera("target.y", targetStep, [](ViewValue& view) -> double& { return view.camera.target.y(); }),
        ofCamera("target.z", targetStep, [](ViewValue& view) -> double& { return view.camera.target.z(); }),
        edit(
            "view.up", [](ViewValue& view, const DrivenWindow&) { view.camera.up = UpAxis::MinusY; },
            inDock("dock.view")),
        edit(
            "view.projection", [](ViewValue& view, const DrivenWindow&) { view.camera.perspective = false; },
            inDock("dock.view")),
        edit(
            "view.turning", [](ViewValue& view, const DrivenWindow&) { view.camera.trackball = true; },
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
            [i](ViewValue& view, const DrivenWindow&) {
                view.annotations.places[i].shown = !view.annotations.places[i].shown;
            },
            inDock("dock.view")));
        if (!isInCorner(static_cast<AnnotationKind>(i)))
            continue;
        drivers.push_back(edit(
            name + ".corner",
            [i](ViewValue& view, const DrivenWindow&) {
                Corner& corner = view.annotations.places[i].corner;
                corner = static_cast<Corner>(nextChoice(static_cast<int>(corner), 4));
            },
            [i](DrivenWindow& window) {
                AnnotationState state = window.session().view().annotations;
                state.places[i].shown = true;
                window.session().setAnnotations(state);
                window.raise("dock.view");
            }));
    }
    return drivers;
}

/// The colour bar's ends, fixed to those of the values.
void fixBarEnds(DrivenWindow& window)
{
    const auto [least, largest] = rangeOf(window);
    AnnotationState state = window.session().view().annotations;
    state.barEnds = BarEnds{least, largest};
    window.session().setAnnotations(state);
    window.raise("dock.view");
}

Drivers barEndControls()
{
    const auto end = [](const QString& name, double BarEnds::*member) {
        const QString box = "view.barEnds." + name;
        const auto reach = [member](ViewValue& view) -> double& { return view.annotations.barEnds.value().*member; };
        return edit(box, moves(reach, stepOfBox(box, hundredthOf(&rangeOf))), &fixBarEnds);
    };
    return {
        edit(
            "view.barEnds.fixed",
            [](ViewValue& view, const DrivenWindow& window) {
                const auto [least, largest] = rangeOf(window);
                view.annotations.barEnds = BarEnds{least, largest};
            },
            inDock("dock.view")),
        end("least", &BarEnds::least),
        end("largest", &BarEnds::largest),
    };
}

/// A text that is typed and finished with Return.
Driver annotationText(const QString& name, std::string AnnotationState::*text, AnnotationKind kind)
{
    const QString line = "view.annotationText." + name;
    return edit(
        line, [text](ViewValue& view, const DrivenWindow&) { view.annotations.*text = "Own"; },
        [kind](DrivenWindow& window) {
            AnnotationState state = window.session().view().annotations;
            state[kind].shown = true;
            window.session().setAnnotations(state);
            window.raise("dock.view");
        },
        [line](DrivenWindow& window) {
            QTest::keyClicks(&window.find<QLineEdit>(line), "Own");
            QTest::keyClick(&window.find<QLineEdit>(line), Qt::Key_Return);
        });
}

/// Numbers of lengths are written.
void showBoxAxes(DrivenWindow& window)
{
    AnnotationState state = window.session().view().annotations;
    state[AnnotationKind::BoxAxes].shown = true;
    window.session().setAnnotations(state);
    window.raise("dock.view");
}

Drivers annotationTextControls()
{
    return {
        annotationText("title", &AnnotationState::title, AnnotationKind::Title),
        annotationText("quantity", &AnnotationState::quantity, AnnotationKind::ColourBar),
        annotationText("unit", &AnnotationState::unit, AnnotationKind::ColourBar),
        edit(
            "view.numbers.style",
            [](ViewValue& view, const DrivenWindow&) { view.annotations.numbers.style = NumberFormat::Style::Plain; },
            inDock("dock.view")),
        edit(
            "view.numbers.decimals", [](ViewValue& view, const DrivenWindow&) { ++view.annotations.numbers.decimals; },
            [](DrivenWindow& window) {
                AnnotationState state = window.session().view().annotations;
                state.numbers.style = NumberFormat::Style::Powers;
                window.session().setAnnotations(state);
                window.raise("dock.view");
            }),
        edit(
            "view.lengths.style",
            [](ViewValue& view, const DrivenWindow&) { view.annotations.lengths.style = NumberFormat::Style::Plain; },
            &showBoxAxes),
        edit(
            "view.lengths.decimals", [](ViewValue& view, const DrivenWindow&) { ++view.annotations.lengths.decimals; },
            [](DrivenWindow& window) {
                AnnotationState state = window.session().view().annotations;
                state.lengths.style = NumberFormat::Style::Powers;
                window.session().setAnnotations(state);
                showBoxAxes(window);
            }),
        edit(
            "view.textSize", [](ViewValue& view, const DrivenWindow&) { ++view.annotations.textSize; },
            inDock("dock.view")),
        edit(
            "view.boldText",
            [](ViewValue& view, const DrivenWindow&) { view.annotations.boldText = !view.annotations.boldText; },
            inDock("dock.view")),
    };
}

Drivers viewControls()
{
    return {
        edit(
            "view.background",
            [](ViewValue& view, const DrivenWindow&) { view.background = paletteColour(chosenColour); },
            inDock("dock.view"), choosingColour("view.background")),
        edit(
            "view.usualBackground", [](ViewValue& view, const DrivenWindow&) { view.background.reset(); },
            [](DrivenWindow& window) {
                window.session().setBackground(Colour{1, 0, 0});
                window.raise("dock.view");
            }),
        opening("view.load", "cameraDialog", inDock("dock.view")),
        opening("view.save", "cameraSaveDialog", inDock("dock.view")),
    };
}

Drivers isovalueControls()
{
    const auto value = [](ViewValue& view) -> double& { return view.isovalues.front().value; };
    const auto opacity = [](ViewValue& view) -> float& { return view.isovalues.front().opacity; };
    // Percentages of whole numbers: one less than all.
    const AimFrom lessOpaque = [](const DrivenWindow&, double before) -> Aim { return {before - 0.01, 0.0051}; };
    const auto change = [](void (*changes)(Isovalue & isovalue)) {
        return [changes](ViewValue& view, const DrivenWindow&) { changes(view.isovalues.front()); };
    };
    const Driver::Step dock = inDock("dock.isovalues");
    return {
        edit("isovalue.0.visible", change([](Isovalue& isovalue) { isovalue.visible = false; }), dock),
        edit(
            "isovalue.0.remove",
            [](ViewValue& view, const DrivenWindow&) { view.isovalues.erase(view.isovalues.begin()); }, dock),
        edit("isovalue.0.value.slider", moves(value, stepOfSlider(&rangeOf)), dock),
        edit("isovalue.0.value.box", moves(value, stepOfBox("isovalue.0.value.box", hundredthOf(&rangeOf))), dock),
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
            [](ViewValue& view, const DrivenWindow& window) {
                view.isovalues.push_back(nextIsovalue(view.isovalues, window.session().range()));
            },
            dock),
    };
}

} // namespace

Drivers lookControls()
{
    return allOf({renderingControls(), sliceSettings(), cameraControls(), annotationControls(), barEndControls(),
                  annotationTextControls(), viewControls(), isovalueControls()});
}

} // namespace tetra
