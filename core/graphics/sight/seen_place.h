// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/graphics/sight/sight_line.h"

#include <cstddef>
#include <optional>

namespace tetra {

/// What one sees along a line of sight, and where.
struct SeenPlace {
    Eigen::Vector3d place{0, 0, 0};
    std::optional<std::size_t> surface{}; ///< of Scene::surfaces; none: it is in the volume
    double value = 0;                     ///< of the field there; not said of a surface whose mesh has no values
    double share = 0;                     ///< of the light that the surface, or the whole volume, takes; in (0, 1]
};

/// What contributes most to the picture at a line of sight, with the light that is left behind what lies before it:
/// that surface which takes most of it, or if all of the volume takes more, the place in the volume where most is taken
/// on a unit of length. That is the largest extinction(t) * e^-depth(t), of which each slab has the largest in closed
/// form: where the extinction is the square root of its rise, or at an end. Where a focus counts for more than a half
/// its volume is looked at; in the border of a box somewhat before the corners.
///
/// Nothing where less than 1/255 of the light is taken, as nothing is seen there. Unlike the largest jump of the
/// opacity (A. Wiebel et al., "WYSIWYP: What You See Is What You Pick", 2012) it needs no smoothing of a sampled curve.
/// O(triangles + cells). Nothing if cancelled. May throw std::bad_alloc.
std::optional<SeenPlace> seenPlace(const Scene& scene, const SightLine& line, const Progress& progress = {});

} // namespace tetra
