// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/parameter_values.h"

#include "plugins/host/parameter_text.h"

#include <algorithm>

namespace tetra {
namespace {

std::string kindOf(DomainClass domain)
{
    switch (domain) {
    case DomainClass::RegularLattice: return "is a regular lattice";
    case DomainClass::Curvilinear: return "is a curvilinear grid";
    case DomainClass::Irregular: return "is an irregular mesh";
    case DomainClass::Scattered: break;
    }
    return "has scattered points";
}

} // namespace

Status checkParameterValues(const std::string& owner, const std::vector<Parameter>& parameters,
                            const ParameterValues& values)
{
    std::string ids;
    for (const Parameter& parameter : parameters)
        ids += (ids.empty() ? "" : ", ") + parameter.id;
    for (const auto& [id, value] : values) {
        const auto known = std::ranges::find(parameters, id, &Parameter::id);
        if (known == parameters.end())
            return Error{ErrorKind::WrongUsage, "The " + owner + " knows no parameter '" + id + "'. " +
                                                    (ids.empty() ? "It has none." : "It has: " + ids + ".")};
        if (known->defaultValue.index() != value.index())
            return Error{ErrorKind::WrongUsage,
                         "The parameter '" + id + "' of the " + owner + " takes " + parameterDomain(*known) + "."};
    }
    return {};
}

ParameterValues withDomain(ParameterValues values, DomainClass domain)
{
    values[domainId] = std::string(domainClassName(domain));
    return values;
}

Status checkOfUse(const std::vector<Parameter>& parameters, const ParameterValues& values, const Dataset& dataset,
                  const std::string& prefix)
{
    const ParameterValues known = withDomain(values, dataset.domain);
    for (const Parameter& parameter : parameters) {
        if (!values.contains(parameter.id) || matters(parameter, parameters, known))
            continue;
        std::string wanted;
        for (const ParameterValue& value : parameter.onlyWith.values)
            wanted += (wanted.empty() ? "" : " or ") + parameterText(value);
        const std::string name = "'" + prefix + parameter.id + "'";
        if (parameter.onlyWith.id == domainId)
            return Error{ErrorKind::WrongUsage, name + " is of " + wanted + " data only, and '" + dataset.source.name +
                                                    "' " + kindOf(dataset.domain) + ". Leave it out."};
        return Error{ErrorKind::WrongUsage, name + " is of use only if '" + prefix + parameter.onlyWith.id + "' is " +
                                                wanted + ". Leave it out, or choose that."};
    }
    return {};
}

} // namespace tetra
