// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/graphics/isosurface_index.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// An edge of a mesh as a number: its smaller vertex, times 2^32, plus the larger one.
using EdgeKey = std::uint64_t;

/// The ends of an edge, smaller one first.
inline std::array<std::uint32_t, 2> endsOf(EdgeKey edge) noexcept
{
    return {static_cast<std::uint32_t>(edge >> 32), static_cast<std::uint32_t>(edge)};
}

/// The piece of an isosurface in one run of surfaceRunSize tetrahedra.
struct SurfaceRun {
    std::vector<EdgeKey> edges;                          ///< that it crosses, each once, in order of appearance
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< of indices among its edges
};

/// Marches through the tetrahedra that have corners on both sides; a vertex is inside if its value is at least
/// `isovalue` (S16). Without an index all are looked at. O(vertices + tetrahedra), on all threads. Incomplete if
/// cancelled. May throw std::bad_alloc.
std::vector<SurfaceRun> makeSurfaceRuns(const TetrahedralMesh& mesh, const IsosurfaceIndex* index, double isovalue,
                                        const Progress& progress);

} // namespace tetra
