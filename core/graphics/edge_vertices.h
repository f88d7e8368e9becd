// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/graphics/crossed_tetrahedra.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The vertices of an isosurface: one for each crossed edge of the mesh, however many tetrahedra share the edge.
struct EdgeVertices {
    /// The edge that each vertex lies on, smaller mesh vertex first.
    Buffer<std::array<std::uint32_t, 2>> edges;
    /// The vertex of each corner, in the order of the chunks, their entries, and the corners of the marching case.
    Buffer<std::uint32_t> cornerVertex;
    /// Where in cornerVertex each chunk begins, and after the last chunk the end.
    std::vector<std::uint64_t> firstCorner;
};

/// The largest number of corners that numberEdgeVertices can number.
inline constexpr std::uint64_t largestCornerCount = 0xffffffff;

/// Numbers the crossed edges: first inside each chunk, then what is left is dealt by hash to a fixed number of parts,
/// so that every hash table fits the cache. O(corners), on all threads, and the same numbering with any number of them.
/// Up to 30 bytes a corner while it runs. May throw std::bad_alloc.
EdgeVertices numberEdgeVertices(const TetrahedralMesh& mesh, std::span<const CrossedChunk> chunks);

} // namespace tetra
