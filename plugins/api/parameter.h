// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/isovalue.h"
#include "core/transfer/transfer_function.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace tetra {

/// The value of a plugin's parameter.
using ParameterValue = std::variant<bool, std::int64_t, double, std::string, std::vector<Isovalue>, TransferFunction>;
/// Values by parameter id; what is missing has its default.
using ParameterValues = std::map<std::string, ParameterValue>;

/// A parameter as data: the shell makes forms, command-line options and session entries from it. The type is that of
/// `defaultValue`. Texts are for the user, in English, and are translated by the shell.
struct Parameter {
    std::string id; ///< stable: the command line's --id and the session's key
    std::string label;
    std::string explanation; ///< one sentence, for tooltips and --help
    std::string unit;        ///< "%", "points" ..., empty if none
    ParameterValue defaultValue;
    double minimum = 0;                 ///< of numbers
    double maximum = 0;                 ///< of numbers; not above minimum means unbounded
    std::vector<std::string> choices{}; ///< of strings; empty means free text
    /// Of strings that are lists, else 0: what separates their entries. On the command line, entries may also be given
    /// one at a time; the list's option is then called by its id without the plural s.
    char separator = 0;
    /// Of strings: why a text cannot be used, for the user; empty if it can. May be missing. Quick, any thread.
    std::function<std::string(const std::string& text)> mistake{};
};

/// The value of `id` in `values`, else the default of the description in `parameters`. T is the parameter's type; a
/// value of another type counts as missing.
template <class T>
T parameterValue(const std::vector<Parameter>& parameters, const ParameterValues& values, const std::string& id)
{
    if (const auto found = values.find(id); found != values.end())
        if (const T* value = std::get_if<T>(&found->second))
            return *value;
    for (const Parameter& parameter : parameters)
        if (parameter.id == id)
            if (const T* value = std::get_if<T>(&parameter.defaultValue))
                return *value;
    return T{};
}

} // namespace tetra
