// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/mesh.h>

#include <array>

namespace tetra {

/// An isosurface with few triangles, and how good it is (C14).
struct SurfaceQuality {
    std::size_t triangles = 0;
    double rootMeanSquare = 0; ///< distance of the finest surface's vertices from it, % of the diagonal of that surface
    double largest = 0;        ///< the same
    std::size_t crossings = 0; ///< of its triangles: those that meet the surface of the other isovalue
};

/// The two isosurfaces of a coarse mesh beside the finest ones simplified by their geometry, as the paper's section 6
/// compares them: an isosurface and a second one of a value nearby.
struct SurfaceComparison {
    SurfaceQuality fromData;
    SurfaceQuality simplified;
    double simplifyingSeconds = 0; ///< of the first surface
};

/// Whether this program has CGAL (the option TAN_CGAL); without it compareSurfaces() gives zeros.
extern const bool canCompareSurfaces;

/// Simplifies the finest surfaces by edge collapse (P. Lindstrom and G. Turk, Fast and memory efficient polygonal
/// simplification, 1998; CGAL's) to as many triangles as the surfaces of the data have, and measures both. Surfaces
/// that have no triangles give zeros.
SurfaceComparison compareSurfaces(const std::array<TriangleMesh, 2>& fromData,
                                  const std::array<TriangleMesh, 2>& finest);

} // namespace tetra
