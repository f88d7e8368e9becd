// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/graphics/scene.h"
#include "core/mesh/tetrahedral_mesh.h"

namespace tetra {

/// Where the boundary turns by more than this many degrees there is an edge to see; less is a curve in few faces.
inline constexpr double usualFeatureAngle = 30;

/// The boundary of a mesh as a surface: its boundaryFaces(), cavities and all components included, counterclockwise
/// seen from outside, with the values of the field. Normals look outwards and are smooth where neighbouring triangles
/// turn by at most `featureAngle` degrees, 0 for flat ones: means of the triangles' normals, weighted by their angles
/// (G. Thürmer and C. Wüthrich, "Computing vertex normals from polygonal facets", 1998). At a sharper edge, and where
/// other than two triangles meet, a vertex comes once for each side. O(vertices + tetrahedra + boundary log boundary),
/// the same result with any number of threads. Errors: cancelled, too many tetrahedra, not enough memory.
Result<TriangleMesh> extractBoundary(const TetrahedralMesh& mesh, double featureAngle = usualFeatureAngle,
                                     const Progress& progress = {});

} // namespace tetra
