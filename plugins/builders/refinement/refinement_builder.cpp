// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/refinement_builder.h"

#include "core/data/weighting.h"
#include "plugins/api/weights_parameter.h"
#include "plugins/builders/refinement/block_choice.h"
#include "plugins/builders/refinement/curvilinear_build.h"
#include "plugins/builders/refinement/lattice_build.h"
#include "plugins/builders/refinement/scattered_build.h"

#include <optional>
#include <string_view>

namespace tetra {

namespace {

std::string notYet(const Dataset& dataset)
{
    return "Refinement does not take " + std::string(domainClassName(dataset.domain)) + " data.";
}

Parameter errorParameter()
{
    Parameter error;
    error.id = "error";
    error.label = "Error";
    error.explanation = "The error at which to stop; 0 keeps everything, so that any accuracy can be looked at later.";
    error.unit = "% of the value range";
    error.defaultValue = 0.0;
    error.minimum = 0;
    error.maximum = 100;
    return error;
}

constexpr std::string_view normalised = "normalised";
constexpr std::string_view paper = "paper";

ParameterCondition forCurvilinear()
{
    return {domainId, {std::string(domainClassName(DomainClass::Curvilinear))}};
}

Parameter warpingParameter()
{
    Parameter warping;
    warping.id = "warping";
    warping.label = "Warping";
    warping.explanation =
        "For curvilinear data: the warping at which to stop. Its ratio to the error says how much the "
        "shape counts against the values, 1 : 1 if either is 0; 0 keeps everything.";
    warping.unit = "% of the diagonal";
    warping.defaultValue = 0.0;
    warping.minimum = 0;
    warping.maximum = 100;
    warping.onlyWith = forCurvilinear();
    return warping;
}

Parameter selectionParameter()
{
    Parameter selection;
    selection.id = "selection";
    selection.label = "Selection";
    selection.explanation = "For curvilinear data: 'normalised' takes the point that is farthest off in error or "
                            "warping; 'paper' compares the two in the units of the data, as the paper did, to "
                            "compare with it. Both keep cells from turning over.";
    selection.defaultValue = std::string(normalised);
    selection.choices = {std::string(normalised), std::string(paper)};
    selection.onlyWith = forCurvilinear();
    return selection;
}

CurvilinearBuildRequest curvilinearRequest(const std::vector<Parameter>& parameters, const ParameterValues& values,
                                           const Weighting& weighting, std::optional<std::uint32_t> cells)
{
    CurvilinearBuildRequest request;
    request.weighting = weighting;
    request.blockEdge = cells.value_or(0);
    request.error = parameterValue<double>(parameters, values, "error");
    request.warping = parameterValue<double>(parameters, values, "warping");
    if (parameterValue<std::string>(parameters, values, "selection") == paper)
        request.selection = CurvilinearSelection::Paper;
    return request;
}

} // namespace

Acceptance RefinementBuilder::accepts(const Dataset& dataset) const
{
    switch (dataset.domain) {
    case DomainClass::RegularLattice: return acceptLattice(dataset);
    case DomainClass::Curvilinear: return acceptCurvilinear(dataset);
    case DomainClass::Scattered: return acceptScattered(dataset);
    case DomainClass::Irregular: break;
    }
    return {0, notYet(dataset)};
}

std::vector<Parameter> RefinementBuilder::parameters() const
{
    return {errorParameter(), warpingParameter(), blockParameter(), selectionParameter(), weightsParameter()};
}

Result<BuildReport> RefinementBuilder::build(const Dataset& dataset, const ParameterValues& values, BuildTarget& target,
                                             const Progress& progress) const
{
    const double error = parameterValue<double>(parameters(), values, "error");
    const auto weighting = parseWeighting(parameterValue<std::string>(parameters(), values, "weights"));
    if (!weighting)
        return weighting.error();
    const auto block = parameterValue<std::string>(parameters(), values, "block");
    const auto cells = givenBlocks(block);
    if (!cells)
        return cells.error();
    switch (dataset.domain) {
    case DomainClass::RegularLattice: return buildLattice(dataset, {error, block, *weighting}, target, progress);
    case DomainClass::Curvilinear:
        return buildCurvilinear(dataset, curvilinearRequest(parameters(), values, *weighting, *cells), target,
                                progress);
    case DomainClass::Scattered: return buildScattered(dataset, error, *weighting, target, progress);
    case DomainClass::Irregular: break;
    }
    return Error{ErrorKind::BadInput, notYet(dataset)};
}

} // namespace tetra
