// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/scene_pick.h"

#include "core/graphics/sight/surface_crossings.h"

namespace tetra {

std::optional<Eigen::Vector3d> placeSeenAt(const Scene& scene, const PictureProjection& projection, QPointF pixel)
{
    const SightLine line = projection.sightLine(pixel);
    const auto crossings = surfaceCrossings(scene.surfaces, line, shownPart(line, scene.clipPlanes));
    std::optional<Eigen::Vector3d> place;
    double light = 1; // that is left
    double most = 0;  // that one of them takes
    for (const SurfaceCrossing& crossing : crossings) {
        const double opacity = scene.surfaces[crossing.surface].opacity;
        if (light * opacity > most) {
            most = light * opacity;
            place = line.at(crossing.at);
        }
        light *= 1 - opacity;
    }
    return place;
}

} // namespace tetra
