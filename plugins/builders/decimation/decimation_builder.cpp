// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/decimation/decimation_builder.h"

#include "core/base/byte_text.h"
#include "core/base/memory.h"
#include "core/data/weighting.h"
#include "core/mesh/decimation/decimation.h"
#include "plugins/api/weights_parameter.h"
#include "plugins/builders/decimation/decimation_input.h"
#include "plugins/builders/decimation/decimation_need.h"

#include <string_view>

namespace tetra {

namespace {

constexpr std::string_view exact = "exact", paper = "paper", rounds = "rounds";

Parameter percentParameter(std::string id, std::string label, std::string explanation, std::string unit)
{
    Parameter parameter;
    parameter.id = std::move(id);
    parameter.label = std::move(label);
    parameter.explanation = std::move(explanation);
    parameter.unit = std::move(unit);
    parameter.defaultValue = 0.0;
    parameter.minimum = 0;
    parameter.maximum = 100;
    return parameter;
}

Parameter orderParameter()
{
    Parameter order;
    order.id = "order";
    order.label = "Order";
    order.explanation =
        "Which point goes next: 'exact' takes the one whose loss does the least harm, for the fewest points; 'paper' "
        "estimates that by gradients and planes, as the paper did; 'rounds' takes many points at a time that do not "
        "touch, so that a focus region needs the least besides.";
    order.defaultValue = std::string(exact);
    order.choices = {std::string(exact), std::string(paper), std::string(rounds)};
    return order;
}

DecimationOrder orderOf(const std::string& name)
{
    if (name == paper)
        return DecimationOrder::PaperEstimates;
    return name == rounds ? DecimationOrder::IndependentRounds : DecimationOrder::ExactError;
}

/// A constant field has no range and coinciding points have no diagonal; any unit will do for what is 0 anyway.
double unitOf(double extent)
{
    return extent > 0 ? extent : 1;
}

/// `error` and `warping`: where to stop, in percent (R7); 0 is no threshold. The ratio of both says what a warping is
/// worth in errors; a percent is worth a percent if there is but one of them.
DecimationOptions optionsFor(const Dataset& dataset, double error, double warping)
{
    const double valueUnit = unitOf(dataset.values.range().extent()) / 100;
    const double lengthUnit = unitOf(dataset.bounds().diagonal().norm()) / 100;
    DecimationOptions options;
    options.warpingWeight = valueUnit / lengthUnit;
    if (error > 0 && warping > 0)
        options.warpingWeight *= error / warping;
    if (error > 0 || warping > 0)
        options.stopKey = (error > 0 ? error : warping) * valueUnit;
    return options;
}

std::string reasonFor(const Dataset& dataset)
{
    switch (dataset.domain) {
    case DomainClass::Irregular: return "An irregular mesh: decimation keeps its shape and its cavities.";
    case DomainClass::Curvilinear:
        return "A curvilinear grid: decimation takes fewer points for the same accuracy, but more time and memory.";
    case DomainClass::RegularLattice:
        return "A regular lattice: decimation takes fewer points for the same accuracy, but more time and memory.";
    case DomainClass::Scattered: break;
    }
    return "Scattered points have no tetrahedra that decimation could begin with. Refine them instead.";
}

/// Why the dataset cannot be decimated at all.
Status checkInput(const Dataset& dataset)
{
    if (dataset.domain == DomainClass::Scattered)
        return Error{ErrorKind::BadInput, reasonFor(dataset)};
    const DecimationSize size = decimationSize(dataset);
    if (size.tetrahedra == 0)
        return Error{ErrorKind::BadInput, "A tetrahedral mesh needs a cell: two points or more along each axis."};
    return checkDecimationNeed(size, usableBytes());
}

} // namespace

Acceptance DecimationBuilder::accepts(const Dataset& dataset) const
{
    if (const Status possible = checkInput(dataset); !possible)
        return {0, possible.error().text};
    return {dataset.domain == DomainClass::Irregular ? 1.0 : 0.5, reasonFor(dataset)};
}

std::vector<Parameter> DecimationBuilder::parameters() const
{
    Parameter warping =
        percentParameter("warping", "Warping",
                         "For curvilinear and irregular data: the warping at which to stop. Its ratio to the error "
                         "says how much the shape counts against the values, 1 : 1 if either is 0, and then the "
                         "other holds for both; two of 0 go on to the coarsest mesh.",
                         "% of the diagonal");
    for (const DomainClass domain : {DomainClass::Curvilinear, DomainClass::Irregular})
        warping.onlyWith.values.emplace_back(std::string(domainClassName(domain)));
    warping.onlyWith.id = domainId;
    return {percentParameter("error", "Error", "The error at which to stop; 0 goes on to the coarsest mesh.",
                             "% of the value range"),
            warping, orderParameter(), weightsParameter()};
}

Result<BuildReport> DecimationBuilder::build(const Dataset& dataset, const ParameterValues& values, BuildTarget& target,
                                             const Progress& progress) const
{
    if (const Status possible = checkInput(dataset); !possible)
        return possible.error();
    const std::vector<Parameter> known = parameters();
    const auto weighting = parseWeighting(parameterValue<std::string>(known, values, "weights"));
    if (!weighting)
        return weighting.error();
    const auto input = DecimationInput::make(dataset, *weighting, progress.part(0, 0.02));
    if (!input)
        return input.error();
    DecimationOptions options = optionsFor(dataset, parameterValue<double>(known, values, "error"),
                                           parameterValue<double>(known, values, "warping"));
    options.order = orderOf(parameterValue<std::string>(known, values, "order"));
    const DecimationMesh mesh = input->mesh();
    const auto result = decimate(mesh, options, target.history, progress.part(0.02, 1));
    if (!result)
        return result.error();
    BuildReport report{result->sites, result->tetrahedra, 0, 0};
    if (dataset.domain == DomainClass::Curvilinear) {
        const LiftedSigns signs = liftedSigns(dataset, mesh.tetrahedra);
        report.inverted = signs.inverted;
        report.degenerate = signs.degenerate;
    }
    return report;
}

} // namespace tetra
