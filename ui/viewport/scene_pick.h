// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/scene.h"
#include "ui/viewport/picture_projection.h"

#include <optional>

namespace tetra {

/// The place on a surface that is seen at a pixel: where no clip plane cuts it away, and of several the one that is
/// seen most, so that a faint boundary does not stand before what is in it. Nothing where no surface is.
/// O(triangles).
std::optional<Eigen::Vector3d> placeSeenAt(const Scene& scene, const PictureProjection& projection, QPointF pixel);

} // namespace tetra
