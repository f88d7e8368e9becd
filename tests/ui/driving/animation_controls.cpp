// SPDX-License-Identifier: GPL-3.0-or-later
// How the controls of the dock Animation are driven, and what each changes.
#include "tests/ui/driving/driver.h"

#include <QTableWidget>

#include <utility>

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

using AnimationEdit = std::function<void(Animation& animation, const DrivenWindow& window)>;

Driver ofFilm(const QString& name, const AnimationEdit& change, Driver::Step prepare = inDock("dock.animation"),
              Driver::Step use = {})
{
    return edit(
        "animation." + name, [change](ViewValue& view, const DrivenWindow& window) { change(view.animation, window); },
        std::move(prepare), std::move(use));
}

/// Of the chosen one, at place 1.
Driver ofKeyFrames(const QString& name, const AnimationEdit& change, Driver::Step use = {})
{
    return ofFilm("keys" + name, change, &beginWithKeyFrames, std::move(use));
}

void removeChosen(Animation& animation, const DrivenWindow&)
{
    animation.keys.erase(animation.keys.begin() + 1);
}

/// The views change places, the times stay.
AnimationEdit exchanges(std::size_t one, std::size_t other)
{
    return [=](Animation& animation, const DrivenWindow&) {
        std::swap(animation.keys[one].frame, animation.keys[other].frame);
    };
}

bool showsAFrame(const DrivenWindow& window)
{
    return window.viewport().previewing() && window.viewport().shownCamera() != window.viewport().camera();
}

} // namespace

Drivers animationControls()
{
    constexpr double usualPause = 2; // seconds from one view to the next
    const Drivers edits{
        ofFilm("kind", [](Animation& film, const DrivenWindow&) { film.kind = Animation::Kind::KeyFrames; }),
        ofFilm("rate", [](Animation& film, const DrivenWindow&) { film.framesPerSecond += 1; }),
        ofFilm("axis", [](Animation& film, const DrivenWindow&) { film.turntable.axis = Turntable::Axis::Horizontal; }),
        ofFilm("degrees", [](Animation& film, const DrivenWindow&) { film.turntable.degrees += 90; }),
        ofFilm("frames", [](Animation& film, const DrivenWindow&) { film.turntable.frames += 1; }),
        ofKeyFrames(".add",
                    [](Animation& film, const DrivenWindow& window) {
                        film.keys.push_back({film.keys.back().time + usualPause, frameOf(window.session().view())});
                    }),
        ofKeyFrames(
            ".update",
            [](Animation& film, const DrivenWindow& window) { film.keys[1].frame = frameOf(window.session().view()); }),
        ofKeyFrames(".remove", &removeChosen),
        ofKeyFrames(".up", exchanges(1, 0)),
        ofKeyFrames(".down", exchanges(1, 2)),
        ofKeyFrames("", &removeChosen, [](DrivenWindow& window) { window.press("animation.keys", Qt::Key_Delete); }),
    };
    const Drivers others{
        edit(
            "animation.keys.show", [](ViewValue& view, const DrivenWindow&) { view.camera.azimuth = 70; },
            &beginWithKeyFrames),
        showing("animation.play", &showsAFrame, inDock("dock.animation")),
        showing("animation.position", &showsAFrame, inDock("dock.animation")),
        opening("animation.save", "filmOptions", inDock("dock.animation")),
    };
    return allOf({edits, others});
}

} // namespace tetra
