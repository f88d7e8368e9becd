// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/refinement_builder.h"

#include "plugins/builders/refinement/lattice_build.h"

namespace tetra {

namespace {

std::string notYet(const Dataset& dataset)
{
    return "Refinement does not take " + std::string(domainClassName(dataset.domain)) + " data.";
}

} // namespace

Acceptance RefinementBuilder::accepts(const Dataset& dataset) const
{
    switch (dataset.domain) {
    case DomainClass::RegularLattice: return acceptLattice(dataset);
    case DomainClass::Curvilinear:
    case DomainClass::Scattered:
    case DomainClass::Irregular: break;
    }
    return {0, notYet(dataset)};
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

Result<BuildReport> RefinementBuilder::build(const Dataset& dataset, const ParameterValues& values, BuildTarget& target,
                                             const Progress& progress) const
{
    const double error = parameterValue<double>(parameters(), values, "error");
    switch (dataset.domain) {
    case DomainClass::RegularLattice: return buildLattice(dataset, error, target, progress);
    case DomainClass::Curvilinear:
    case DomainClass::Scattered:
    case DomainClass::Irregular: break;
    }
    return Error{ErrorKind::BadInput, notYet(dataset)};
}

} // namespace tetra
