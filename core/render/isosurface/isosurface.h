// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/spatial_order.h"
#include "core/mesh/topology.h"

#include <tan/mesh.h>

#include <tan/render.h>

#include <cstddef>
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

/// The same surface to the last bit of its positions, vertices and triangles in another order, by an index of the same
/// mesh: several times quicker if the mesh is in spatial order.
Result<TriangleMesh> extractIsosurface(const TetrahedralMesh& mesh, const IsosurfaceIndex& index,
                                       std::span<const Eigen::Vector3f> gradients, double isovalue,
                                       const Progress& progress = {});

/// A surface with the edge of the mesh that each of its vertices lies on.
struct Contour {
    TriangleMesh surface;
    Buffer<EdgeKey> edges;
};

/// An isosurface of any numbers, one for each vertex of the mesh, in place of its own values; `index`, of those
/// numbers, may be null, and so may `cells`, for the tetrahedra of the triangles. Arguments are not checked. May throw
/// std::bad_alloc.
Result<Contour> extractContour(const TetrahedralMesh& mesh, std::span<const float> values, const IsosurfaceIndex* index,
                               std::span<const Eigen::Vector3f> gradients, double isovalue, const Progress& progress,
                               Buffer<std::uint32_t>* cells = nullptr);

/// Fills in the normals of `surface` that are zero: the mean of the normals of the triangles, weighted by area; a
/// vertex without one gets +z. O(vertices + triangles), one thread.
void fillNormalsFromTriangles(TriangleMesh& surface);

} // namespace tetra
