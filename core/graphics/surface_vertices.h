// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/graphics/surface_runs.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The vertices of an isosurface: one for each crossed edge of the mesh, whatever runs share the edge.
struct SurfaceVertices {
    Buffer<EdgeKey> edges; ///< that each vertex lies on
    /// The vertex of each of the runs' edges, run after run.
    Buffer<std::uint32_t> numbers;
    std::vector<std::size_t> firstOfRun; ///< among `numbers`, and after the last run the end
};

/// The largest number of edges of all runs together that numberVertices can number.
inline constexpr std::uint64_t largestRunEdgeCount = 0xffffffff;

/// Numbers the edges of a mesh with so many vertices. Most belong to one run only, as its index tells, or else the
/// edges at their smaller ends; the others are dealt by hash to a fixed number of parts, so that every hash table fits
/// the cache. O(edges), on all threads, and the same numbering with any number of them. May throw std::bad_alloc.
SurfaceVertices numberVertices(std::span<const SurfaceRun> runs, const IsosurfaceIndex* index, std::size_t vertexCount);

} // namespace tetra
