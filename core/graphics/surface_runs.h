// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/base/progress.h"
#include "core/graphics/crossed_edges.h"
#include "core/graphics/isosurface_index.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// The piece of an isosurface in one run of surfaceRunSize tetrahedra.
struct SurfaceRun {
    std::vector<EdgeKey> edges;                     ///< that it crosses, each once, in order of appearance
    Buffer<std::array<std::uint32_t, 3>> triangles; ///< of indices among its edges
};

/// Marches through the tetrahedra that have corners on both sides; a vertex is inside if its value is at least
/// `isovalue` (S16). Without an index all are looked at. O(vertices + tetrahedra), on all threads. Incomplete if
/// cancelled. May throw std::bad_alloc.
std::vector<SurfaceRun> makeSurfaceRuns(const TetrahedralMesh& mesh, const IsosurfaceIndex* index, double isovalue,
                                        const Progress& progress);

} // namespace tetra
