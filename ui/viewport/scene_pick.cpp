// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/scene_pick.h"

#include "core/graphics/sight/surface_crossings.h"

namespace tetra {

std::optional<Eigen::Vector3d> placeSeenAt(const Scene& scene, const PictureProjection& projection, QPointF pixel)
{
    const SightLine line = projection.sightLine(pixel);
    const auto crossings = surfaceCrossings(scene.surfaces, line, shownPart(line, scene.clipPlanes));
    return crossings.empty() ? std::nullopt : std::optional(line.at(crossings.front().at));
}

} // namespace tetra
