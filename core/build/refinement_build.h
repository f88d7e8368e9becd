// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/build.h>

#include <cstdint>
#include <optional>

namespace tetra {

/// Why the dataset cannot be refined, for the user; success if it can.
TAN_INTERNAL Status checkRefinement(const Dataset& dataset);

/// Whether a lattice of so many points is refined in blocks, as far as that can be known of their number. `block`:
/// Refinement::block; `usableBytes`: of memory, 0 if unknown.
TAN_INTERNAL bool takesBlocks(const std::optional<std::uint32_t>& block, std::uint64_t points,
                              std::uint64_t usableBytes);

/// The cells along an edge of the blocks of a regular lattice, 0 to refine it as a whole. Error: WrongUsage, so small
/// blocks would be too many.
TAN_INTERNAL Result<std::uint32_t> chooseBlocks(const std::optional<std::uint32_t>& block, const Lattice& lattice,
                                                std::uint64_t usableBytes);

/// Greedy Delaunay refinement of lattices, curvilinear grids and scattered points into a target (R8, R9, R10, R12). In
/// blocks a lattice is refined out of core, which needs BuildTarget::ofFixedSize.
TAN_INTERNAL Result<BuildReport> buildInto(const Dataset& dataset, const Refinement& refinement, BuildTarget& target,
                                           const Progress& progress);

} // namespace tetra
