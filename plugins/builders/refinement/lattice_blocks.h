// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/builder.h"

#include <cstdint>
#include <span>

namespace tetra {

/// What is to be built.
struct LatticeBlocks {
    double stopError = 0;           ///< in units of the values
    std::uint32_t cells = 0;        ///< along an edge of a block
    std::span<const float> weights; ///< one a point, or none
};

/// Refines a regular lattice block by block, out of core, and merges the blocks into one model (R10, B6). Needs
/// BuildTarget::planned.
Result<BuildReport> buildLatticeInBlocks(const Dataset& dataset, const LatticeBlocks& blocks, BuildTarget& target,
                                         const Progress& progress);

} // namespace tetra
