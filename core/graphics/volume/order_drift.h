// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/camera.h"

#include <Eigen/Geometry>

namespace tetra {

/// How far a visibility order made for one camera is from fitting another: the largest angle in degrees, at the centre
/// and the corners of `bounds`, between the directions to both eyes. 0 if the eye stayed (in orthographic views, if it
/// only moved along or across them): then the order of a convex domain is exact still. With small angles few faces are
/// passed by the eye, and only their cells are in wrong order. 180 if the projection changed, or the eye moved inside.
double orderDrift(const Eigen::AlignedBox3d& bounds, const Camera& from, const Camera& to);

} // namespace tetra
