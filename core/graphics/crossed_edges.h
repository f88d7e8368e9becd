// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/crossed_tetrahedra.h"

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// An edge of a mesh as a number: its smaller vertex, times 2^32, plus the larger one.
using EdgeKey = std::uint64_t;

/// The ends of an edge, smaller one first.
inline std::array<std::uint32_t, 2> endsOf(EdgeKey edge) noexcept
{
    return {static_cast<std::uint32_t>(edge >> 32), static_cast<std::uint32_t>(edge)};
}

/// Writes the edges that the corners of each tetrahedron's piece of the surface lie on, three or four in the order of
/// its marching case; `crossed` are some of `tetrahedra`. `edges` has room for four of each. Returns the end of what
/// counts. O(crossed).
EdgeKey* writeCrossedEdges(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                           std::span<const CrossedTetrahedron> crossed, EdgeKey* edges);

} // namespace tetra
