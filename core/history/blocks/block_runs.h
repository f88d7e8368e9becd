// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/blocks/run_files.h"
#include "core/refine/curvilinear/curvilinear_refinement.h"
#include "core/refine/lattice/block_division.h"
#include "core/refine/lattice/lattice_refinement.h"

#include <tan/base.h>

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace tetra {

/// What the runs of some blocks came to.
struct RunTotals {
    std::uint64_t points = 0; ///< of the blocks' lattices
    std::uint64_t sites = 0;  ///< points on shared faces more than once
    std::uint64_t tetrahedra = 0;
    std::uint64_t fileBytes = 0;
    std::uint64_t living = 0; ///< of the tetrahedra, those of the mesh of all sites
};

/// What all blocks have in common.
struct BlockRunsOptions {
    BlockDivision division{{2, 2, 2}, 0};
    std::optional<PartNumber> part{}; ///< of a shared build: only the blocks of this part; else all
    bool waits = false;               ///< for what other parts find out of faces; else NotYet
    bool resumes = false;             ///< goes on with what an interrupted build that nobody shares knew of cures
    /// Asked before a run is written; an Error ends the work. Called from any thread.
    std::function<Status()> samplesIntact;
    /// Asked after each block with what there is and what there will be as it seems, from a first sample of blocks on;
    /// an Error ends the work. Called from one thread at a time, and not while progress is told.
    std::function<Status(const RunTotals& soFar, const RunTotals& expected)> check;
};

struct LatticeRunsOptions : BlockRunsOptions {
    LatticeBoxOptions box; ///< for every block but for its place: lattice size, metric, value extent, stop
};

/// Refines every block of a lattice by itself (R10) and leaves its run in `runs`, unless it is there: on all threads
/// that TBB may use, in memory for one block each. Errors: memory, the disk, check's, cancelled.
Status makeLatticeRuns(const LatticeRunsOptions& options, const LatticeSamples& samples, RunFiles& runs,
                       const Progress& progress);

struct CurvilinearRunsOptions : BlockRunsOptions {
    CurvilinearBoxOptions box; ///< for every block but for its place: size, facts, warping weight, stop, extents
};

/// Likewise every block of a curvilinear grid (C7, S4). Where a block needs cures on its faces, all blocks that have
/// these points are refined again, with the cures, in rounds until none needs another. What is known is kept in the
/// runs' folder after each round, so that a build that is resumed goes on with it. Which blocks a round refines, and
/// with what, depends on the data alone. The rounds end: after `mostRounds` a face on which a cure is missing gets all
/// of its points.
///
/// Of a shared build each part leaves a file for each round in the runs' folder, which tells the others what its blocks
/// need. A part that has done its own share of a round, and lacks a file of another part, waits for it, or ends with
/// NotYet and goes on from there when it is begun again.
Status makeCurvilinearRuns(const CurvilinearRunsOptions& options, std::span<const Eigen::Vector3d> positions,
                           const LatticeSamples& samples, RunFiles& runs, const Progress& progress,
                           std::uint32_t mostRounds = 16);

} // namespace tetra
