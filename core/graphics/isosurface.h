// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/graphics/scene.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <span>

namespace tetra {

/// The field's gradient at each vertex: the mean of the gradients of its tetrahedra, weighted by volume.
/// O(tetrahedra); one vector a vertex.
Buffer<Eigen::Vector3f> vertexGradients(const TetrahedralMesh& mesh);

/// Marching tetrahedra (R19): the isosurface of the piecewise-linear field, a vertex for each crossed edge, shared by
/// its triangles. A vertex is inside if its value >= isovalue (S16), so the surface is closed but for the domain's
/// boundary, on any data. Triangles wind so that their front looks towards smaller values; normals come from
/// `gradients` (vertexGradients of the same mesh) and look the same way. Triangles without area are left out.
Result<TriangleMesh> extractIsosurface(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients,
                                       double isovalue, const Progress& progress = {});

} // namespace tetra
