// SPDX-License-Identifier: GPL-3.0-or-later
// How the controls of the dock Animation are driven.
#include "tests/ui/driving/driver.h"

#include <QTableWidget>

namespace tetra {
namespace {

/// Three views from other sides, the second one chosen.
void beginWithKeyFrames(DrivenWindow& window)
{
    Animation animation = window.session().view().animation;
    animation.kind = Animation::Kind::KeyFrames;
    for (const double azimuth : {10.0, 70.0, 130.0}) {
        FilmFrame frame = frameOf(window.session().view());
        frame.camera.azimuth = azimuth;
        animation = withKey(animation, frame);
    }
    window.session().setAnimation(animation);
    window.raise("dock.animation");
    window.find<QTableWidget>("animation.keys").setCurrentCell(1, 1);
}

Driver ofKeyFrames(const QString& name)
{
    return {"animation.keys." + name, changes(&ViewValue::animation), &beginWithKeyFrames};
}

bool showsAFrame(const DrivenWindow& window)
{
    return window.viewport().previewing() && window.viewport().shownCamera() != window.viewport().camera();
}

} // namespace

Drivers animationControls()
{
    Drivers drivers;
    for (const char* name : {"kind", "rate", "axis", "degrees", "frames"})
        drivers.push_back({QString("animation.") + name, changes(&ViewValue::animation), inDock("dock.animation")});
    for (const char* name : {"add", "update", "remove", "up", "down"})
        drivers.push_back(ofKeyFrames(name));
    const Drivers others{
        {"animation.keys.show", [](const DrivenWindow& window) { return window.viewport().camera().azimuth == 70; },
         &beginWithKeyFrames},
        {"animation.keys", changes(&ViewValue::animation), &beginWithKeyFrames,
         [](DrivenWindow& window) { window.press("animation.keys", Qt::Key_Delete); }},
        showing("animation.play", &showsAFrame, inDock("dock.animation")),
        showing("animation.position", &showsAFrame, inDock("dock.animation")),
        opening("animation.save", "filmOptions", inDock("dock.animation")),
    };
    return allOf({drivers, others});
}

} // namespace tetra
