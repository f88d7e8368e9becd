// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/face_adjacency.h"
#include "core/mesh/tetrahedral_mesh.h"

namespace tetra {

/// Whether the domain of a mesh is convex, but for dents no deeper than a hundred thousandth of its own size: no two
/// faces of the boundary meet at an edge that is bent inwards, each edge has two of them, and they hang together. False
/// if in doubt. O(cells + boundary log boundary), one thread. May throw std::bad_alloc.
bool hasConvexBoundary(const TetrahedralMesh& mesh, const FaceAdjacency& adjacency);

} // namespace tetra
