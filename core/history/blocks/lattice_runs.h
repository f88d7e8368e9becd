// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/blocks/block_run.h"
#include "core/refine/lattice/block_division.h"
#include "core/refine/lattice/lattice_refinement.h"

#include <tan/base.h>

#include <cstdint>
#include <functional>

namespace tetra {

/// What the runs of some blocks came to.
struct RunTotals {
    std::uint64_t points = 0; ///< of the blocks' lattices
    std::uint64_t sites = 0;  ///< points on shared faces more than once
    std::uint64_t tetrahedra = 0;
    std::uint64_t fileBytes = 0;
    std::uint64_t living = 0; ///< of the tetrahedra, those of the mesh of all sites
};

struct LatticeRunsOptions {
    BlockDivision division{{2, 2, 2}, 0};
    LatticeBoxOptions box;    ///< for every block but for its place: lattice size, metric, value extent, stop
    bool reuseIntact = false; ///< runs that are there already are not made again
    /// Asked before a run is written; an Error ends the work. Called from any thread.
    std::function<Status()> samplesIntact;
    /// Asked after each block with what there is and what there will be as it seems, from a first sample of blocks on;
    /// an Error ends the work. Called from one thread at a time, and not while progress is told.
    std::function<Status(const RunTotals& soFar, const RunTotals& expected)> check;
};

/// Refines every block of a lattice by itself (R10) and leaves its run in `runs`: on all threads that TBB may use, in
/// memory for one block each. Errors: memory, the disk, check's, cancelled.
Status makeLatticeRuns(const LatticeRunsOptions& options, const LatticeSamples& samples, const RunFiles& runs,
                       const Progress& progress);

} // namespace tetra
