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

/// How far places of `from` are from the nearest place of `to`: its vertices that a triangle has, and of triangles that
/// are larger than most of `to` the corners of pieces as large as those; if that were many more places than both
/// surfaces have vertices, of larger pieces. Between these places the distance may be larger. A third of the area of
/// the pieces around a place counts for it in the mean. Both have triangles. A tree over the triangles of `to`: O(n
/// log^2 n) to build it, then some microseconds a place, on all threads, the same result with any number of them.
/// Errors: cancelled, not enough memory.
TAN_INTERNAL Result<SurfaceDistance> surfaceDistance(const TriangleMesh& to, const TriangleMesh& from,
                                                     const Progress& progress = {});

} // namespace tetra
