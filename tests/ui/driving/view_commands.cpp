// SPDX-License-Identifier: GPL-3.0-or-later
// How the actions of the menu View are driven, and what each changes (R27).
#include "tests/ui/driving/driver.h"
#include "tests/ui/driving/scene_facts.h"
#include "ui/session/language.h"
#include "ui/widgets/motion.h"

#include <QDockWidget>
#include <QToolBar>

namespace tetra {
namespace {

using CameraEdit = std::function<void(Camera& camera)>;

Driver cameraCommand(const QString& name, const CameraEdit& change, Driver::Step prepare = {})
{
    return edit(
        "action." + name, [change](ViewValue& view, const DrivenWindow&) { change(view.camera); }, std::move(prepare));
}

Driver sideCommand(const QString& side, double azimuth, double elevation, Driver::Step prepare = {})
{
    return cameraCommand(
        "view." + side,
        [=](Camera& camera) {
            camera.azimuth = azimuth;
            camera.elevation = elevation;
        },
        std::move(prepare));
}

Driver upAxisCommand(const QString& name, UpAxis up)
{
    return cameraCommand(
        "up." + name, [up](Camera& camera) { camera.up = up; },
        [up](DrivenWindow& window) {
            const UpAxis other = up == UpAxis::X ? UpAxis::Y : UpAxis::X;
            window.viewport().setCamera(upright(window.viewport().camera(), other));
        });
}

Drivers orientationCommands()
{
    return {
        upAxisCommand("x", UpAxis::X),
        upAxisCommand("minusX", UpAxis::MinusX),
        upAxisCommand("y", UpAxis::Y),
        upAxisCommand("minusY", UpAxis::MinusY),
        upAxisCommand("z", UpAxis::Z),
        upAxisCommand("minusZ", UpAxis::MinusZ),
        cameraCommand("flip", [](Camera& camera) { camera.up = UpAxis::MinusY; }),
        cameraCommand("rollRight", [](Camera& camera) { camera.roll = 90; }),
        cameraCommand("rollLeft", [](Camera& camera) { camera.roll = -90; }),
        cameraCommand(
            "level", [](Camera& camera) { camera.roll = 0; },
            [](DrivenWindow& window) { window.trigger("action.rollLeft"); }),
        cameraCommand("trackball", [](Camera& camera) { camera.trackball = true; }),
        cameraCommand("perspective", [](Camera& camera) { camera.perspective = false; }),
        sideCommand("front", 0, 0),
        sideCommand("back", 180, 0),
        sideCommand("left", 270, 0),
        sideCommand("right", 90, 0),
        sideCommand("top", 0, 90),
        sideCommand("bottom", 0, -90),
        sideCommand("corner", 30, 20, [](DrivenWindow& window) { window.trigger("action.view.top"); }),
    };
}

void resets(ViewValue& view, const DrivenWindow& window)
{
    view = window.atFirst();
    fitView(view, window);
}

/// All of the view becomes another one.
void changeEverything(DrivenWindow& window)
{
    Session& session = window.session();
    session.setError(1.5);
    session.addIsovalue();
    session.setSetting("outline", false);
    AnnotationState annotations = session.view().annotations;
    annotations[AnnotationKind::Title].shown = true;
    session.setAnnotations(annotations);
    Animation animation = session.view().animation;
    animation.framesPerSecond = 12;
    session.setAnimation(animation);
    session.setCamera(seenFrom(session.view().camera, NamedView::Top));
    window.session().setBackground(Colour{1, 0, 0});
}

Drivers wholeViewCommands()
{
    return {
        edit("action.fit", &fitView, [](DrivenWindow& window) { window.press("viewport", Qt::Key_Plus); }),
        edit("action.fitWhole", &fitWholeView, [](DrivenWindow& window) { window.press("viewport", Qt::Key_Plus); }),
        edit("action.resetView", &resets, &changeEverything),
        edit("action.bookmark.add", [](ViewValue& view, const DrivenWindow&) { view = withBookmark(view, "View 1"); }),
        opening("action.bookmark.edit", "bookmarkDialog"),
    };
}

/// What each mode draws: surfaces, a volume or both.
Driver mode(const QString& id, const QString& before, bool hasVolume, std::size_t surfaces)
{
    return redraw(
        "action.mode." + id, [id](ViewValue& view, const DrivenWindow&) { view.appearance.mode = id.toStdString(); },
        [=](const DrivenWindow& window) {
            const bool isChosen = window.session().view().appearance.mode == id.toStdString();
            const SceneFacts scene = isChosen && window.settled() ? factsOf(*window.viewport().scene()) : SceneFacts{};
            return isChosen && window.settled() && scene.hasVolume == hasVolume && scene.surfaces == surfaces;
        },
        [before](DrivenWindow& window) { window.choose(before); });
}

Drivers modeCommands()
{
    return {mode("isosurface", "volume", false, 1),
            mode("volume", "hybrid", true, 0),
            mode("hybrid", "focus", true, 1),
            mode("focus", "isosurface", true, 0),
            mode("slice", "volume", false, 3),
            mode("projection", "isosurface", true, 0),
            mode("example.two-functions", "volume", false, 0)};
}

Drivers annotationCommands()
{
    Drivers drivers;
    for (std::size_t i = 0; i < annotationCount; ++i)
        drivers.push_back(
            edit(QString("action.annotation.") + annotationNames[i], [i](ViewValue& view, const DrivenWindow&) {
                view.annotations.places[i].shown = !view.annotations.places[i].shown;
            }));
    return drivers;
}

Drivers dockCommands()
{
    Drivers drivers;
    for (const QString name : {"build", "accuracy", "rendering", "view", "statistics", "isovalues", "transfer", "focus",
                               "region", "animation", "tools"})
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
    return allOf({orientationCommands(), wholeViewCommands(), modeCommands(), annotationCommands(), dockCommands(),
                  languageCommands(), others});
}

} // namespace tetra
