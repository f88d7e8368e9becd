// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/scene.h"
#include "core/graphics/vertex_placing.h"

#include <span>

namespace tetra {

/// Makes one vertex of those that lie in the same vertex of the mesh: the edges of a vertex whose value is the isovalue
/// all cross there. Keeps the order, and leaves out the triangles that have no area then; without welding, leaving them
/// out would tear the surface. O(vertices + triangles), all threads for triangles. May throw std::bad_alloc.
void weldAtMeshVertices(std::span<const Tie> ties, TriangleMesh& surface);

} // namespace tetra
