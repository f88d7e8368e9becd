// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/scene_pick.h"

#include "core/graphics/sight/seen_place.h"

namespace tetra {

std::optional<Eigen::Vector3d> placeSeenAt(const Scene& scene, const PictureProjection& projection, QPointF pixel)
{
    Scene surfaces;
    surfaces.surfaces = scene.surfaces;
    surfaces.clipPlanes = scene.clipPlanes;
    const auto seen = seenPlace(surfaces, projection.sightLine(pixel));
    return seen ? std::optional(seen->place) : std::nullopt;
}

} // namespace tetra
