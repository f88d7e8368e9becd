// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/spatial_order.h"
#include "core/mesh/tetrahedral_mesh.h"
#include "core/render/scene.h"

#include <cstdint>
#include <span>

namespace tetra {

/// Tetrahedra whose piece of a surface is made by one thread. Runs do not depend on the number of threads, so neither
/// does anything that is numbered by them.
inline constexpr std::size_t surfaceChunkSize = std::size_t(1) << 14;

/// What makes isosurfaces of a mesh quicker, at their best if it is in spatial order. Immutable; share it between
/// threads.
struct IsosurfaceIndex {
    Buffer<ChunkRange> ranges;     ///< chunks that no surface can cross are passed over
    Buffer<std::uint8_t> inOneRun; ///< 1 for each vertex whose tetrahedra are all in one run of surfaceChunkSize
};

/// Once a mesh: O(tetrahedra), on all threads of the current arena. May throw std::bad_alloc.
IsosurfaceIndex makeIsosurfaceIndex(const TetrahedralMesh& mesh);

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

/// Fills in the normals of `surface` that are zero: the mean of the normals of the triangles, weighted by area; a
/// vertex without one gets +z. O(vertices + triangles), one thread.
void fillNormalsFromTriangles(TriangleMesh& surface);

} // namespace tetra
