// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/edge_vertices.h"
#include "core/graphics/scene.h"
#include "core/graphics/vertex_welding.h"

#include <span>

namespace tetra {

/// Gives `surface`, whose positions and triangles are there, its unit normals: against the gradient, interpolated along
/// each vertex's edge. Where that has no direction (the field is flat there, or not finite) the mean of the normals of
/// the triangles, weighted by area; a vertex with neither gets +z.
void makeNormals(TriangleMesh& surface, const EdgeVertices& vertices, const CrossingPoints& points,
                 std::span<const Eigen::Vector3f> gradients);

} // namespace tetra
