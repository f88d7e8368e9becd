// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/scene_pick.h"

#include <exception>
#include <variant>

namespace tetra {
namespace {

std::optional<SeenPlace> seenOrNothing(const Scene& scene, const PickingRay& line, const Progress& progress)
try {
    return seenPlace(scene, line, progress);
} catch (const std::exception&) { // no memory, or what an optical model of a plugin throws
    return std::nullopt;
}

} // namespace

void ScenePick::find(std::shared_ptr<const Scene> scene, const PickingRay& line, Found found)
{
    job_.submit(
        [this, number = ++newest_, scene = std::move(scene), line, found = std::move(found)](std::stop_token stop) {
            const auto seen = seenOrNothing(*scene, line, Progress(std::move(stop), {}));
            QMetaObject::invokeMethod(
                this,
                [this, number, found, seen] {
                    if (number != newest_)
                        return;
                    done_ = number;
                    found(seen);
                },
                Qt::QueuedConnection);
        });
}

void ScenePick::forget()
{
    done_ = ++newest_;
    job_.cancel();
}

std::shared_ptr<const Scene> surfacesOf(const Scene& scene)
{
    auto surfaces = std::make_shared<Scene>();
    surfaces->clipPlanes = scene.clipPlanes;
    for (const Drawable& drawable : scene.drawables)
        if (std::holds_alternative<Surface>(drawable.shape))
            surfaces->drawables.push_back(drawable);
    return surfaces;
}

} // namespace tetra
