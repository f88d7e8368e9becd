// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/sight/sight_line.h"

#include <cstddef>
#include <vector>

namespace tetra {

/// Where a line of sight passes through a surface.
struct SurfaceCrossing {
    double at = 0;           ///< of SightLine
    std::size_t surface = 0; ///< of Scene::surfaces
    double value = 0;        ///< of the field there, if the surface tells
};

/// The crossings with what is drawn of the surfaces within `part`, the nearest first. Where the line meets an edge of a
/// surface's triangles it passes through the surface once. O(triangles).
std::vector<SurfaceCrossing> surfaceCrossings(const std::vector<Surface>& surfaces, const SightLine& line,
                                              const SightPart& part);

} // namespace tetra
