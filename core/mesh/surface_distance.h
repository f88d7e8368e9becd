// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/mesh.h>

#include <vector>

namespace tetra {

/// How far places of one surface are from another one.
struct SurfaceDistance {
    double largest = 0;
    double mean = 0; ///< over the area of the surface that the places are of
};

/// Of each vertex of `from` that a triangle has the distance to the nearest place of `to`, a third of its triangles'
/// area counting for it in the mean. Both have triangles. A tree over the triangles of `to`: O(n log^2 n) to build it,
/// then some microseconds a vertex, on all threads, the same result with any number of them. Errors: cancelled, not
/// enough memory.
TAN_INTERNAL Result<SurfaceDistance> surfaceDistance(const TriangleMesh& to, const TriangleMesh& from,
                                                     const Progress& progress = {});

} // namespace tetra
