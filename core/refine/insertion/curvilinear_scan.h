// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/curvilinear/curvilinear_grid.h"
#include "core/refine/insertion/local_delaunay.h"
#include "core/refine/insertion/sample_scan.h"
#include "core/refine/lattice/block_division.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// How large error and warping may be at each point of a curvilinear grid, in its order: in units of the values and of
/// length.
struct CurvilinearLimits {
    std::vector<double> errors;
    std::vector<double> warpings;
    /// Elsewhere than in these points limits are the largest of all. Empty if first > last.
    std::array<std::int32_t, 3> first{0, 0, 0};
    std::array<std::int32_t, 3> last{-1, -1, -1};
};

/// Looks at the points of a curvilinear grid in tetrahedra of its computational space (closed, so that those on faces
/// are looked at more than once), but for vertices, and appends the worst of each tetrahedron that has one whose error
/// or warping is beyond its limit (R4, R5). Instead of that, for a tetrahedron that is flipped in physical space and
/// may not stay so, its cure (S5), of infinite excess. What lies where and what is flipped is found exactly.
void scanCurvilinearSamples(const LocalDelaunay& mesh, std::span<const std::uint32_t> slots,
                            const CurvilinearGrid& grid, const BlockDivision& blocks, const CurvilinearLimits& limits,
                            ScannedPart part, std::vector<WorstSample>& worst);

} // namespace tetra
