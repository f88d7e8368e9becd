// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/lattice_build.h"

#include "core/mesh/lattice_metric.h"
#include "core/mesh/lattice_refinement.h"

namespace tetra {

Acceptance acceptLattice(const Dataset& dataset)
{
    if (const auto metric = latticeMetric(dataset.lattice.size, dataset.lattice.spacing); !metric)
        return {0, metric.error().text};
    return {1, "A regular lattice: refinement keeps the exact domain and needs the least time."};
}

Result<BuildReport> buildLattice(const Dataset& dataset, double error, const Weighting& weighting, BuildTarget& target,
                                 const Progress& progress)
{
    const Result<std::vector<float>> weights = pointWeights(weighting, dataset, progress);
    if (!weights)
        return weights.error();
    LatticeRefinementOptions options;
    options.size = dataset.lattice.size;
    options.spacing = dataset.lattice.spacing;
    options.valueExtent = dataset.values.range().extent();
    options.stopError = error / 100 * dataset.values.range().extent();
    const Result<LatticeRefinementResult> result = visitSampleType(dataset.values.type(), [&]<class T>() {
        return refineLattice(options, LatticeSamples(dataset.values.as<T>(), *weights), target.history, progress);
    });
    if (!result)
        return result.error();
    return BuildReport{result->sites, result->tetrahedra, 0, 0};
}

} // namespace tetra
