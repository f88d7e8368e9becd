// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/verify/irregular_original.h"
#include "core/verify/level_faces.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace tetra {

/// Whether two triangles that are not flat have a place in common besides the points that they share by number: they
/// cross, touch, or lie on one another. Exact for all finite doubles. At most two points are shared.
bool facesMeet(std::span<const Eigen::Vector3d> positions, const PointTriangle& first, const PointTriangle& second);

/// Whether the segment and the triangle, which is not flat, have a place in common, their ends included. Exact.
bool segmentMeetsTriangle(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b, const Eigen::Vector3d& c);

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
                      LevelReport& verdict, const Progress& progress);

} // namespace tetra
