// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scenes/error_measuring.h"

#include "core/history/error_meaning.h"
#include "core/verify/verify_mesh.h"

#include <stop_token>

namespace tetra {

void ErrorMeasuring::look(const BuiltScene& scene)
{
    const quint64 number = ++newest_;
    job_.cancel();
    // While the worker makes the next scene, the mesh of this one is gone, or will be.
    const auto mesh = scenes_.busy() ? nullptr : scenes_.mesh();
    if (!mesh || scene.mesh.isBlended || scene.mesh.errorMeaning != ErrorMeaning::InGrid)
        return;
    if (mesh == measured_.lock())
        return tell(known_);
    job_.submit([this, number, mesh, model = scene.model, query = scene.mesh.query](const std::stop_token& stop) {
        const auto found = measureInSpace(*model, query, *mesh, Progress(stop, {}));
        if (!found) // cancelled; what else is wrong, the next mesh tells
            return;
        const std::optional<double> largest = *found ? std::optional((*found)->largest) : std::nullopt;
        QMetaObject::invokeMethod(
            this,
            [this, number, largest, measured = std::weak_ptr(mesh)] {
                if (number != newest_)
                    return;
                measured_ = measured;
                known_ = largest;
                tell(largest);
            },
            Qt::QueuedConnection);
    });
}

void ErrorMeasuring::tell(const std::optional<double>& largest)
{
    if (!session_.shown() || !largest)
        return;
    ShownMesh shown = *session_.shown();
    shown.errorInSpace = largest;
    session_.setShown(shown);
}

} // namespace tetra
