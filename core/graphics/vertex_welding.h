// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/graphics/edge_vertices.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <Eigen/Core>

namespace tetra {

/// Where the vertices of an isosurface lie, before those in one place become one.
struct CrossingPoints {
    Buffer<Eigen::Vector3f> positions;
    Buffer<float> fractions; ///< of the way from the edge's first end to its second, in [0, 1]
    /// The mesh vertex that a crossing coincides with, or `none`.
    Buffer<std::uint32_t> meshVertices;
    static constexpr std::uint32_t none = 0xffffffff;
};

/// Interpolates along the edges in double precision. Both ends being on different sides, the fraction is defined; where
/// a value is infinite or NaN it is some number in [0, 1].
CrossingPoints crossingPoints(const TetrahedralMesh& mesh, const EdgeVertices& vertices, double isovalue);

/// Makes one vertex of the crossings that coincide with the same mesh vertex: the edges of a vertex whose value is the
/// isovalue all cross there. Renumbers `vertices` and `points`, keeping the order. Without this the triangles between
/// such crossings would have no area, and leaving them out would tear the surface. O(vertices + ties log ties).
void weldAtMeshVertices(EdgeVertices& vertices, CrossingPoints& points);

} // namespace tetra
