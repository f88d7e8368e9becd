// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/lattice_build.h"

#include "core/base/memory.h"
#include "core/refine/lattice/lattice_refinement.h"
#include "plugins/builders/refinement/block_choice.h"
#include "plugins/builders/refinement/lattice_blocks.h"

#include <span>
#include <vector>

namespace tetra {

namespace {

Result<BuildReport> buildLatticeAsWhole(const Dataset& dataset, double stopError, std::span<const float> weights,
                                        BuildTarget& target, const Progress& progress)
{
    LatticeRefinementOptions options;
    options.size = dataset.lattice.size;
    options.spacing = dataset.lattice.spacing;
    options.valueExtent = dataset.values.range().extent();
    options.stopError = stopError;
    const Result<LatticeRefinementResult> result = visitSampleType(dataset.values.type(), [&]<class T>() {
        return refineLattice(options, LatticeSamples(dataset.values.as<T>(), weights), target.history, progress);
    });
    if (!result)
        return result.error();
    return BuildReport{result->sites, result->tetrahedra, 0, 0};
}

std::string sizeText(const Lattice& lattice)
{
    return std::to_string(lattice.size[0]) + " x " + std::to_string(lattice.size[1]) + " x " +
           std::to_string(lattice.size[2]);
}

} // namespace

Acceptance acceptLattice(const Dataset& dataset)
{
    constexpr std::uint64_t mostPoints = 1ull << 32;
    if (dataset.lattice.pointCount() > mostPoints)
        return {0, "A lattice of " + sizeText(dataset.lattice) +
                       " points is too large: a model holds at most 4294967296. Crop or subsample it."};
    return {1, "A regular lattice: refinement keeps the exact domain and needs the least time."};
}

Result<BuildReport> buildLattice(const Dataset& dataset, const LatticeBuildRequest& request, BuildTarget& target,
                                 const Progress& progress)
{
    const double stopError = request.error / 100 * dataset.values.range().extent();
    const auto cells = chooseBlocks(request.block, dataset.lattice, usableBytes());
    if (!cells)
        return cells.error();
    if (*cells && !target.planned)
        return Error{ErrorKind::WrongUsage, "Blocks cannot be built into this target. Set the block to \"none\"."};
    const Result<std::vector<float>> weights = pointWeights(request.weighting, dataset, progress);
    if (!weights)
        return weights.error();
    if (!*cells)
        return buildLatticeAsWhole(dataset, stopError, *weights, target, progress);
    return buildLatticeInBlocks(dataset, {stopError, **cells, *weights}, target, progress);
}

} // namespace tetra
