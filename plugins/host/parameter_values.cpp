// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/parameter_values.h"

#include "plugins/host/parameter_text.h"

#include <algorithm>

namespace tetra {
namespace {

Message kindOf(const Dataset& dataset)
{
    const std::string& name = dataset.source.name;
    switch (dataset.domain) {
    case DomainClass::RegularLattice: return Message::say("'%1' is a regular lattice", name);
    case DomainClass::Curvilinear:
        return dataset.convex ? Message::say("'%1' is a rectilinear grid", name)
                              : Message::say("'%1' is a curvilinear grid", name);
    case DomainClass::Irregular: return Message::say("'%1' is an irregular mesh", name);
    case DomainClass::Scattered: break;
    }
    return Message::say("'%1' has scattered points", name);
}

/// The first of `values` that makes no difference beside `known`, which are the values and what else is known.
const Parameter* uselessOne(const std::vector<Parameter>& parameters, const ParameterValues& values,
                            const ParameterValues& known)
{
    const auto found = std::ranges::find_if(parameters, [&](const Parameter& parameter) {
        return values.contains(parameter.id) && !matters(parameter, parameters, known);
    });
    return found != parameters.end() ? &*found : nullptr;
}

/// The values that the parameter's condition asks for: "curvilinear or irregular".
Message wantedBy(const Parameter& parameter)
{
    Message wanted;
    for (const ParameterValue& value : parameter.onlyWith.values) {
        const Message one = Message::of(parameterText(value), {});
        wanted = wanted.empty() ? one : Message::say("%1 or %2", wanted, one);
    }
    return wanted;
}

std::string nameOf(const Parameter& parameter, const OptionOfParameter& optionOf)
{
    return optionOf ? optionOf(parameter) : parameter.id;
}

/// Beside what another one of `parameters` is.
Error uselessBeside(const std::vector<Parameter>& parameters, const Parameter& useless,
                    const OptionOfParameter& optionOf)
{
    const std::string name = nameOf(useless, optionOf);
    const auto other = std::ranges::find(parameters, useless.onlyWith.id, &Parameter::id);
    const std::string otherName = other != parameters.end() ? nameOf(*other, optionOf) : useless.onlyWith.id;
    if (useless.onlyWith.values == std::vector<ParameterValue>{std::string()}) // a text that is not to be given
        return {ErrorKind::WrongUsage,
                Message::say("'%1' applies only without '%2'. Leave one of them out.", name, otherName)};
    if (!optionOf || other == parameters.end() || !std::holds_alternative<bool>(other->defaultValue))
        return {ErrorKind::WrongUsage, Message::say("'%1' applies only if '%2' is %3. Leave it out, or choose that.",
                                                    name, otherName, wantedBy(useless))};
    // A switch is given or not; what it is by default is not enough, or there would be no error.
    return {ErrorKind::WrongUsage,
            std::get<bool>(other->defaultValue)
                ? Message::say("'%1' applies only without '%2'. Leave one of them out.", name, otherName)
                : Message::say("'%1' applies only with '%2'. Leave it out, or give both.", name, otherName)};
}

} // namespace

Status checkParameterValues(const Message& owner, const std::vector<Parameter>& parameters,
                            const ParameterValues& values)
{
    std::string ids;
    for (const Parameter& parameter : parameters)
        ids += (ids.empty() ? "" : ", ") + parameter.id;
    for (const auto& [id, value] : values) {
        const auto known = std::ranges::find(parameters, id, &Parameter::id);
        if (known == parameters.end())
            return Error{ErrorKind::WrongUsage, Message::say("The %1 has no parameter '%2'. %3", owner, id,
                                                             ids.empty() ? Message::say("It has none.")
                                                                         : Message::say("Available: %1.", ids))};
        if (!haveOneType(known->defaultValue, value))
            return Error{ErrorKind::WrongUsage,
                         Message::say("The parameter '%1' of the %2 takes %3.", id, owner, parameterDomain(*known))};
    }
    return {};
}

ParameterValues withDomain(ParameterValues values, const Dataset& dataset)
{
    values[domainId] = domainNameOf(dataset);
    return values;
}

std::vector<std::pair<std::string, std::string>> usedTexts(const std::vector<Parameter>& parameters,
                                                           const ParameterValues& values, const Dataset& dataset)
{
    const ParameterValues known = withDomain(values, dataset);
    std::vector<std::pair<std::string, std::string>> texts;
    for (const Parameter& parameter : parameters) {
        if (!matters(parameter, parameters, known))
            continue;
        const auto given = values.find(parameter.id);
        texts.emplace_back(parameter.id, parameterText(given != values.end() ? given->second : parameter.defaultValue));
    }
    return texts;
}

Status checkOfUse(const std::vector<Parameter>& parameters, const ParameterValues& values, const Dataset& dataset,
                  const OptionOfParameter& optionOf)
{
    const ParameterValues known = withDomain(values, dataset);
    const Parameter* useless = uselessOne(parameters, values, known);
    if (useless == nullptr)
        return {};
    const auto other = std::ranges::find(parameters, useless->orWith.id, &Parameter::id);
    if (other != parameters.end() && matters(*other, parameters, known))
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' is for %2 data only, and %3. Leave it out, or choose '%4 %5'.",
                                  nameOf(*useless, optionOf), wantedBy(*useless), kindOf(dataset),
                                  nameOf(*other, optionOf), parameterText(useless->orWith.values.front()))};
    if (useless->onlyWith.id == domainId)
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' is for %2 data only, and %3. Leave it out.", nameOf(*useless, optionOf),
                                  wantedBy(*useless), kindOf(dataset))};
    return uselessBeside(parameters, *useless, optionOf);
}

Status checkOfUse(const std::vector<Parameter>& parameters, const ParameterValues& values,
                  const OptionOfParameter& optionOf)
{
    const Parameter* useless = uselessOne(parameters, values, values);
    return useless != nullptr ? Status(uselessBeside(parameters, *useless, optionOf)) : Status();
}

} // namespace tetra
