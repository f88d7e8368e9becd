// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Where a surface of triangles with consistent sides is no manifold.
struct ManifoldBreaches {
    std::vector<std::array<std::uint32_t, 2>> edges; ///< not in two triangles that run along it in opposite directions
    std::vector<std::uint32_t> vertices;             ///< at which triangles form more than one fan, or an open one
    bool none() const { return edges.empty() && vertices.empty(); }
};

/// Each sorted, each once; the ends of breached edges are not among the vertices for that alone. O(n log n).
ManifoldBreaches findBreaches(std::span<const std::array<std::uint32_t, 3>> triangles);

/// For each triangle the number of its component, from 0; triangles that share an edge are of one. The surface is a
/// manifold.
std::vector<std::uint32_t> surfaceComponents(std::span<const std::array<std::uint32_t, 3>> triangles);

} // namespace tetra
