// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/mesh.h>

#include <cstddef>

namespace tetra {

/// The values at the corners of some tetrahedra; what is NaN counts as minus infinity, outside of any isosurface.
struct ChunkRange {
    float smallest;
    float largest;

    /// Whether corners lie on both sides; at the isovalue is inside (S16).
    bool crossedAt(double isovalue) const noexcept
    {
        return static_cast<double>(smallest) < isovalue && static_cast<double>(largest) >= isovalue;
    }
};

/// Tetrahedra that are looked at together, or passed over together.
inline constexpr std::size_t rangedChunkSize = 64;

/// The values of each run of rangedChunkSize tetrahedra, in order. O(tetrahedra), on all threads of the current arena.
/// May throw std::bad_alloc.
Buffer<ChunkRange> chunkRanges(const TetrahedralMesh& mesh);

} // namespace tetra
