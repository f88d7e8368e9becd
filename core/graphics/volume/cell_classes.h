// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/mesh/tetrahedral_mesh.h"
#include "core/transfer/transfer_segments.h"

#include <cstdint>
#include <span>

namespace tetra {

/// The segments of the transfer function that a cell's values lie in, first to last.
struct CellClass {
    static constexpr std::uint16_t nothing = 0xffff;
    std::uint16_t first = nothing;
    std::uint16_t last = nothing;
    bool visible() const noexcept { return first != nothing; }
};

/// The most segments that a class can name.
inline constexpr std::size_t largestSegmentCount = 0xfffe;

/// Tells the cells that show something: those with values in a segment that is not transparent, and no corner without
/// a finite value or place. O(vertices log segments + cells), on all threads of the current arena. May throw
/// std::bad_alloc.
Buffer<CellClass> classifyCells(const TetrahedralMesh& mesh, std::span<const TransferSegment> segments);

} // namespace tetra
