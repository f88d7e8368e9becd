// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/blocks/block_runs.h"

#include <tan/base.h>
#include <tan/build.h>
#include <tan/data.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tetra {

/// Makes the runs of all blocks down to a key. BlockRunsOptions: what the builder wants of all of them.
using RunMaking =
    std::function<Status(const BlockRunsOptions& common, double stopKey, RunFiles& runs, const Progress& progress)>;

/// What is refined in blocks, out of core (R10, B6, C7).
struct BlockedBuild {
    std::uint32_t cells = 0;          ///< along an edge of a block
    std::span<const float> weights{}; ///< one a point, or none
    double keyExtent = 1;             ///< the key of 100 %
    double stopKey = 0;
    double warpingWeight = 0;     ///< HistoryTraits
    double valueExtent = 1;       ///< what the runs' errors count in ...
    double diagonal = 0;          ///< ... and their warpings, 0 where there are none
    std::vector<double> others{}; ///< what the domain's refinement depends on besides
    RunMaking makeRuns{};
};

/// The errors, as shares of the extent and falling, that all blocks are refined to before the first one is refined to
/// the end at `finalError`, if the build is watched or may be kept: only then is there a mesh of the whole domain. The
/// first are the blocks' corners; both take about a tenth of the build's time, as far as the density tells.
std::vector<double> coarseErrors(const SiteDensity& density, double finalError);

/// How many blocks of so many cells along an edge a lattice is cut into.
TAN_INTERNAL std::uint64_t blockCount(const Lattice& lattice, std::uint32_t cells);

/// Refines the blocks one by one, and merges them into one model, whose bytes are the same whether it was watched,
/// kept, resumed, made in parts (BuildTarget::part) or none of these. A build that is cancelled and kept becomes the
/// model of the finest of its coarseErrors() that all blocks have come to; once they are being merged, the whole one.
Result<BuildReport> buildInBlocks(const Dataset& dataset, const BlockedBuild& build, const BuildTarget& target,
                                  const Progress& progress);

} // namespace tetra
