// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <cstdint>
#include <vector>

namespace tetra {

/// The tetrahedra of one run of `chunkSize` that an isosurface crosses, in order. Chunks do not depend on the number of
/// threads, so neither does anything that is numbered by them.
struct CrossedChunk {
    static constexpr std::size_t chunkSize = 1 << 16;

    /// A crossed tetrahedron's index inside the chunk, times 16, plus its marching case.
    std::vector<std::uint32_t> entries;
    std::uint64_t corners = 0; ///< corners of all its triangles and quadrilaterals together

    static std::uint32_t offsetOf(std::uint32_t entry) noexcept { return entry / 16; }
    static std::uint32_t caseOf(std::uint32_t entry) noexcept { return entry % 16; }
};

/// Finds the tetrahedra that have corners on both sides; a vertex is inside if its value is at least `isovalue` (S16).
/// O(vertices + tetrahedra), on all threads. Incomplete if cancelled. May throw std::bad_alloc.
std::vector<CrossedChunk> findCrossedTetrahedra(const TetrahedralMesh& mesh, double isovalue, const Progress& progress);

} // namespace tetra
