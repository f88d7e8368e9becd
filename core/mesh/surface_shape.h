// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/mesh.h>

#include <cstdint>

namespace tetra {

/// What is to be known of a surface before it is printed, or anything is reckoned by its volume.
struct SurfaceShape {
    std::uint32_t parts = 0;        ///< that have no vertex in common
    std::uint64_t openings = 0;     ///< of these that have no vertex in common, holes and rims alike
    std::uint64_t openEdges = 0;    ///< edges of one triangle alone
    std::uint64_t crowdedEdges = 0; ///< edges of more than two
    double area = 0;
    double volume = 0; ///< that it encloses, hollows taken off; says nothing of an open surface

    bool isClosed() const noexcept { return openEdges == 0; }
};

/// O(n) where no vertex has very many triangles; edges on all threads. Incomplete if cancelled. May throw
/// std::bad_alloc.
TAN_INTERNAL SurfaceShape shapeOf(const TriangleMesh& surface, const Progress& progress = {});

enum class SurfaceParts {
    All,
    Outer, ///< of a solid's surface those that look away from what they enclose, so not the walls of its hollows
};

/// Leaves of the surface the part of this kind with the largest area, of equal ones the first, in the same order, and
/// its vertices alone; where no part is of this kind, the largest of all. O(n). May throw std::bad_alloc.
TAN_INTERNAL void keepLargestPart(TriangleMesh& surface, SurfaceParts among = SurfaceParts::All);

} // namespace tetra
