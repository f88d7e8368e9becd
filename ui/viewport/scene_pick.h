// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/scene.h"
#include "ui/viewport/picture_projection.h"

#include <optional>

namespace tetra {

/// The place on a surface that is seen at a pixel: the nearest to the viewer that no clip plane cuts away. Nothing
/// where no surface is.
/// O(triangles).
std::optional<Eigen::Vector3d> placeSeenAt(const Scene& scene, const PictureProjection& projection, QPointF pixel);

} // namespace tetra
