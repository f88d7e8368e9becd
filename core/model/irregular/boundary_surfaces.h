// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tetra {

/// A triangle by the numbers of three points, counterclockwise seen from outside.
using PointTriangle = std::array<std::uint32_t, 3>;

/// The closed surfaces that make up a boundary, what holds of each, and what is wrong with them.
struct BoundarySurfaces {
    struct Surface {
        std::uint32_t firstTriangle = 0; ///< its first one
        std::int64_t euler = 0;          ///< vertices - edges + triangles: 2 for a sphere, 0 for a torus
    };
    std::vector<Surface> surfaces;
    std::vector<std::uint32_t> surfaceOf; ///< of each triangle
    /// Edges that do not belong to two triangles of opposite directions, and vertices whose triangles are not one fan:
    /// by their points. With any, the surfaces mean nothing.
    std::vector<std::array<std::uint32_t, 2>> brokenEdges;
    std::vector<std::uint32_t> brokenVertices;
    bool isManifold() const noexcept { return brokenEdges.empty() && brokenVertices.empty(); }
};

/// Joins triangles over their edges. O(n log n).
BoundarySurfaces boundarySurfaces(std::span<const PointTriangle> triangles);

} // namespace tetra
