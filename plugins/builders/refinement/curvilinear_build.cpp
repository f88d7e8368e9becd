// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/curvilinear_build.h"

#include "core/refine/curvilinear/curvilinear_refinement.h"
#include "core/refine/lattice/packed_lattice.h"

namespace tetra {

Acceptance acceptCurvilinear(const Dataset& dataset)
{
    if (const auto metric = latticeMetric(dataset.lattice.size, {1, 1, 1}); !metric)
        return {0, metric.error().text};
    return {1, "A curvilinear grid: refinement in computational space bounds both error and warping."};
}

Result<BuildReport> buildCurvilinear(const Dataset& dataset, const CurvilinearBuildRequest& request,
                                     BuildTarget& target, const Progress& progress)
{
    const Result<std::vector<float>> weights = pointWeights(request.weighting, dataset, progress);
    if (!weights)
        return weights.error();
    CurvilinearRefinementOptions options;
    const ThresholdKey key = thresholdKey(request.thresholds, dataset);
    options.valueExtent = key.valueExtent;
    options.positionExtent = key.positionExtent;
    options.warpingWeight = key.warpingWeight;
    options.stopKey = key.stopKey.value_or(0);
    options.selection = request.selection;
    options.blockEdge = request.blockEdge;
    const Result<CurvilinearRefinementResult> result =
        visitSampleType(dataset.values.type(), [&]<class T>() -> Result<CurvilinearRefinementResult> {
            return refineCurvilinear(dataset.lattice.size, *dataset.positions,
                                     LatticeSamples(dataset.values.as<T>(), *weights), options, target.history,
                                     progress);
        });
    if (!result)
        return result.error();
    return BuildReport{result->sites, result->tetrahedra, result->inverted, result->degenerate};
}

} // namespace tetra
