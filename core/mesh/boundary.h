// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

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
TAN_INTERNAL BoundaryFaces boundaryFaces(std::size_t vertexCount,
                                         std::span<const std::array<std::uint32_t, 4>> tetrahedra);

/// How the faces of positive tetrahedra lie against each other.
struct MeshFaces {
    static constexpr std::uint32_t none = 0xffffffff;
    std::vector<std::uint32_t> partners; ///< of side 4 t + f, the face of t opposite its corner f: the side against it
    std::vector<std::uint32_t> boundary; ///< the sides without one
    std::vector<std::uint32_t> crowded;  ///< tetrahedra at a face that three or more share, sorted
    std::vector<std::uint32_t> folded;   ///< tetrahedra on the same side of a face as its other one, sorted
};

/// Expected O(tetrahedra); up to 260 bytes each while it works. At most largestAdjacentCellCount of them.
MeshFaces findMeshFaces(std::span<const std::array<std::uint32_t, 4>> tetrahedra);

/// The corners of a side, seen from outside its tetrahedron counterclockwise.
std::array<std::uint32_t, 3> sideCorners(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::uint32_t side);

/// Where a surface of triangles with consistent sides is no manifold.
struct ManifoldBreaches {
    std::vector<std::array<std::uint32_t, 2>> edges; ///< not in two triangles that run along it in opposite directions
    std::vector<std::uint32_t> vertices;             ///< at which triangles form more than one fan, or an open one
    bool none() const { return edges.empty() && vertices.empty(); }
};

/// Each sorted, each once; the ends of breached edges are not among the vertices for that alone. O(n log n).
ManifoldBreaches findBreaches(std::span<const std::array<std::uint32_t, 3>> triangles);

/// For each triangle the number of its piece, from 0, in the order of their first triangles. Triangles are of one piece
/// that share an edge which no third one has; one of `alone`, which is empty or says it of each triangle, is a piece
/// by itself. O(n log n).
std::vector<std::uint32_t> surfacePieces(std::span<const std::array<std::uint32_t, 3>> triangles,
                                         const std::vector<bool>& alone = {});

} // namespace tetra
