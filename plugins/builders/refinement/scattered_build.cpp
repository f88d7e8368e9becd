// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/scattered_build.h"

#include "core/refine/free/scattered_refinement.h"

#include <cmath>
#include <new>

namespace tetra {

Acceptance acceptScattered(const Dataset& dataset)
{
    if (dataset.pointCount() < 4)
        return {0, "A tetrahedral mesh needs four points or more."};
    return {1, "Scattered points: refinement fills their convex hull."};
}

Result<BuildReport> buildScattered(const Dataset& dataset, double error, const Weighting& weighting,
                                   BuildTarget& target, const Progress& progress)
try {
    const Result<std::vector<float>> weights = pointWeights(weighting, dataset, progress);
    if (!weights)
        return weights.error();
    std::vector<double> values(dataset.pointCount());
    for (std::uint64_t point = 0; point < values.size(); ++point) {
        values[point] = dataset.values.at(point);
        if (!std::isfinite(values[point]) || !dataset.position(point).allFinite())
            return Error{ErrorKind::BadInput, "Point " + std::to_string(point) + " of '" + dataset.source.name +
                                                  "' has a position or a value that is not a finite number. Leave it "
                                                  "out."};
    }
    const double stopError = error / 100 * dataset.values.range().extent();
    const Result<ScatteredRefinementResult> result =
        refineScattered({*dataset.positions, values, *weights}, stopError, target.history, progress);
    if (!result)
        return result.error();
    return BuildReport{result->sites, result->tetrahedra, 0, 0};
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource, "Not enough memory to refine these points. Close other programs."};
}

} // namespace tetra
