// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/spatial_order.h"

#include <cstdint>

namespace tetra {

/// Tetrahedra whose piece of a surface is made by one thread. Runs do not depend on the number of threads, so neither
/// does anything that is numbered by them.
inline constexpr std::size_t surfaceRunSize = std::size_t(1) << 14;

/// What makes isosurfaces of a mesh quicker, at their best if it is in spatial order. Immutable; share it between
/// threads.
struct IsosurfaceIndex {
    Buffer<ChunkRange> ranges;     ///< chunks that no surface can cross are passed over
    Buffer<std::uint8_t> inOneRun; ///< 1 for each vertex whose tetrahedra are all in one run of surfaceRunSize
};

/// Once a mesh: O(tetrahedra), on all threads of the current arena. May throw std::bad_alloc.
IsosurfaceIndex makeIsosurfaceIndex(const TetrahedralMesh& mesh);

} // namespace tetra
