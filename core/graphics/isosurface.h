// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/graphics/isosurface_index.h"
#include "core/graphics/scene.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <span>

namespace tetra {

/// The field's gradient at each vertex: the mean of the gradients of its tetrahedra, weighted by volume; zero at a
/// vertex without tetrahedra. O(tetrahedra), on all threads, the same result with any number of them. May throw
/// std::bad_alloc.
Buffer<Eigen::Vector3f> vertexGradients(const TetrahedralMesh& mesh);

/// Marching tetrahedra (R19): the isosurface of the piecewise-linear field, a vertex for each crossed edge, shared by
/// its triangles. A vertex is inside if its value >= isovalue (S16), so the surface is closed but for the domain's
/// boundary, on any data. Edges that all cross in one mesh vertex (its value is the isovalue) share one vertex there,
/// and triangles that lose a corner by that are left out, so no crack opens. Where the inside touches itself along an
/// edge of the mesh, four triangles meet. Triangles wind so that their front looks towards smaller values; normals come
/// from `gradients` (vertexGradients of the same mesh) and look the same way; where the gradient vanishes, from the
/// triangles. O(vertices + tetrahedra), on all threads, the same result with any number of them. Errors: cancelled, not
/// enough memory, arguments that do not belong together.
Result<TriangleMesh> extractIsosurface(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients,
                                       double isovalue, const Progress& progress = {});

/// The same surface to the last bit of its positions, vertices and triangles in another order, by an index of the same
/// mesh: several times quicker if the mesh is in spatial order.
Result<TriangleMesh> extractIsosurface(const TetrahedralMesh& mesh, const IsosurfaceIndex& index,
                                       std::span<const Eigen::Vector3f> gradients, double isovalue,
                                       const Progress& progress = {});

} // namespace tetra
