// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The faces of a mesh that belong to one tetrahedron alone, with vertices of their own numbering.
struct BoundaryFaces {
    std::vector<std::uint32_t> vertices; ///< of the mesh, ascending: vertex v of the faces is vertices[v]
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< numbers in `vertices`; seen from outside counterclockwise
};

/// The boundary of positive tetrahedra of `vertexCount` vertices, cavities and all components included; in the order
/// of the tetrahedra. Closed if the mesh is conforming. At most largestAdjacentCellCount tetrahedra, whose corners
/// exist. O(vertices + tetrahedra), memory as matchFaces(). May throw std::bad_alloc.
BoundaryFaces boundaryFaces(std::size_t vertexCount, std::span<const std::array<std::uint32_t, 4>> tetrahedra);

} // namespace tetra
