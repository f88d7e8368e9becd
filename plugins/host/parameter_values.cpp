// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/parameter_values.h"

#include "plugins/host/parameter_text.h"

#include <algorithm>

namespace tetra {

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

} // namespace tetra
