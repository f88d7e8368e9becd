// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace tetra {

/// How the corners, edges and faces of a cell hang together; numbers of corners as in VTK.
struct CellTopology {
    struct Face {
        std::array<std::uint8_t, 4> corners; ///< seen from outside a positive cell counterclockwise
        std::uint8_t count;                  ///< of corners: 3 or 4
    };
    std::uint8_t cornerCount;
    std::span<const Face> faces;
    std::span<const std::array<std::uint8_t, 2>> edges; ///< in the order in which VTK numbers their middle nodes
};

/// Of the linear cell with the same corners; a voxel's is that of a hexahedron (hexahedronCorner() renumbers it), a
/// polyhedron and a flat cell have none: no corners.
const CellTopology& cellTopology(CellShape shape);

/// How many nodes a cell of this shape has; 0 for polyhedra and flat ones, which have any number.
std::uint32_t nodeCount(CellShape shape);

/// Whether the cell has a node in the middle of each edge.
bool isQuadratic(CellShape shape);

/// The place of a voxel's corner among those of a hexahedron, and the reverse.
constexpr std::uint32_t hexahedronCorner(std::uint32_t voxelCorner)
{
    return voxelCorner ^ ((voxelCorner >> 1) & 1);
}

/// What is called so in messages: "hexahedron".
std::string_view cellShapeName(CellShape shape);

} // namespace tetra
