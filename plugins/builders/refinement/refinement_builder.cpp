// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/refinement_builder.h"

#include "core/mesh/lattice_metric.h"
#include "core/mesh/lattice_refinement.h"

namespace tetra {

Acceptance RefinementBuilder::accepts(const Dataset& dataset) const
{
    if (const auto metric = latticeMetric(dataset.lattice.size, dataset.lattice.spacing); !metric)
        return {0, metric.error().text};
    return {1, "A regular lattice: refinement keeps the exact domain and needs the least time."};
}

std::vector<Parameter> RefinementBuilder::parameters() const
{
    Parameter error;
    error.id = "error";
    error.label = "Error";
    error.explanation = "The error at which to stop; 0 keeps everything, so that any accuracy can be looked at later.";
    error.unit = "% of the value range";
    error.defaultValue = 0.0;
    error.minimum = 0;
    error.maximum = 100;
    return {error};
}

Result<BuildReport> RefinementBuilder::build(const Dataset& dataset, const ParameterValues& values, HistorySink& sink,
                                             const Progress& progress) const
{
    const double percent = parameterValue<double>(parameters(), values, "error");
    LatticeRefinementOptions options;
    options.size = dataset.lattice.size;
    options.spacing = dataset.lattice.spacing;
    options.valueExtent = dataset.values.range().extent();
    options.stopError = percent / 100 * dataset.values.range().extent();
    const Result<LatticeRefinementResult> result = visitSampleType(dataset.values.type(), [&]<class T>() {
        return refineLattice(options, LatticeSamples(dataset.values.as<T>()), sink, progress);
    });
    if (!result)
        return result.error();
    return BuildReport{result->sites, result->tetrahedra, 0, 0};
}

} // namespace tetra
