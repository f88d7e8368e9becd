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
            return Error{ErrorKind::WrongUsage,
                         Message::say("The %1 knows no parameter '%2'. %3", owner, id,
                                      ids.empty() ? Message::say("It has none.") : Message::say("It has: %1.", ids))};
        if (!haveOneType(known->defaultValue, value))
            return Error{ErrorKind::WrongUsage,
                         Message::say("The parameter '%1' of the %2 takes %3.", id, owner, parameterDomain(*known))};
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
            return Error{ErrorKind::WrongUsage, Message::say("%1 is of %2 data only, and '%3' %4. Leave it out.", name,
                                                             wanted, dataset.source.name, kindOf(dataset.domain))};
        return Error{ErrorKind::WrongUsage,
                     Message::say("%1 is of use only if '%2%3' is %4. Leave it out, or choose that.", name, prefix,
                                  parameter.onlyWith.id, wanted)};
    }
    return {};
}

} // namespace tetra
