// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace tetra {

/// The yardstick of refinement: CGAL's Delaunay triangulation (EPICK, compact location) of all n x n x n lattice
/// points, inserted at once with its spatial sort, on one thread. Gives the seconds of the insertion alone.
double cgalBulkInsertionSeconds(std::uint32_t n, std::size_t& cells);

} // namespace tetra
