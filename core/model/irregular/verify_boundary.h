// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/irregular/irregular_original.h"
#include "core/model/level_cells.h"

#include <span>
#include <vector>

namespace tetra {

/// The boundary of a mesh of irregular data, by points of the original.
struct MeshBoundary {
    MeshBoundary(const IrregularOriginal& original, const LevelCells& cells, std::span<const BoundaryFace> faces);
    MeshBoundary(const MeshBoundary&) = delete; // the tree looks at the triangles
    MeshBoundary& operator=(const MeshBoundary&) = delete;

    std::vector<PointTriangle> triangles;
    std::vector<std::uint32_t> cells; ///< of each triangle
    BoundarySurfaces surfaces;
    TriangleTree tree;
};

/// The boundary is a manifold that does not meet itself, and has, surface for surface, the vertices and the Euler
/// characteristic of one of the original's; the cells have the original's components; and they hold what is inside once
/// only. Where the original's own faces meet they may go on doing so. For cells that conform; appends to `verdict`. An
/// Error only if cancelled.
Status verifyBoundary(const IrregularOriginal& original, const LevelCells& cells, const MeshBoundary& boundary,
                      LevelVerdict& verdict, const Progress& progress);

} // namespace tetra
