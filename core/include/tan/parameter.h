// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/parameter.h: what can be chosen of a plugin, as data: its parameters, and values for them.
///
/// A renderer describes its parameters; a view (tan/view.h) keeps what was chosen for them, by their ids, whether or
/// not the plugin is there. Values, and pure functions of them: any thread may call them.
///
/// ~~~{.cpp}
/// /// Whether lines are thick: by what was chosen, or else by what the parameter says is usual.
/// bool hasThickLines(const tetra::ParameterValues& chosen)
/// {
///     tetra::Parameter width;
///     width.id = "line-width";
///     width.label = tetra::Message::marked("Line width");
///     width.unit = "pixels";
///     width.defaultValue = 1.5;
///     width.minimum = 0.5;
///     width.maximum = 20;
///     return tetra::parameterValue<double>({width}, chosen, "line-width") > 2;
/// }
/// ~~~

#include <tan/base.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tetra {

/// A value of a type that plugins have among themselves: a renderer that has a parameter of it, and an editor that
/// edits it. The program keeps it, undoes it and puts it into sessions and models, and does not look into it.
struct OwnValue {
    std::string type; ///< stable, and nobody else's: "example.clipping-curve"
    std::string text; ///< UTF-8, and not large: it is kept at each step of undo; JSON for instance
    bool operator==(const OwnValue&) const = default;
};

/// The value of a plugin's parameter.
using ParameterValue = std::variant<bool, std::int64_t, double, std::string, std::vector<Isovalue>, TransferFunction,
                                    Colour, Eigen::Vector3d, OwnValue>;

/// The type of a value, as editors name it in their metadata ("edits"): boolean, integer, number, text, isovalues,
/// transfer-function, colour, vector, or that of an OwnValue.
inline std::string parameterTypeName(const ParameterValue& value)
{
    if (const auto* own = std::get_if<OwnValue>(&value))
        return own->type;
    constexpr std::string_view names[] = {"boolean",   "integer",           "number", "text",
                                          "isovalues", "transfer-function", "colour", "vector"};
    return std::string(names[value.index()]);
}

/// Whether two values are of one type.
inline bool haveOneType(const ParameterValue& one, const ParameterValue& other)
{
    const auto *own = std::get_if<OwnValue>(&one), *otherOwn = std::get_if<OwnValue>(&other);
    return one.index() == other.index() && (own == nullptr || own->type == otherOwn->type);
}

/// Values by parameter id; what is missing has its default.
using ParameterValues = std::map<std::string, ParameterValue>;

/// The ids of two parameters that all renderers share: std::vector<Isovalue> and TransferFunction. What was chosen for
/// them stays when another renderer takes over.
inline constexpr const char* isovaluesId = "isovalues";
inline constexpr const char* transferId = "transfer";

/// When a parameter matters: while the parameter `id` matters itself and has one of the values. Without an id always.
struct ParameterCondition {
    std::string id{};
    std::vector<ParameterValue> values{};
};

/// A parameter as data: the shell makes forms, command-line options and session entries from it. The type is that of
/// `defaultValue`. Texts are for the user, in English, each marked by Message::marked() where it stands: the window
/// translates them.
struct Parameter {
    std::string id{}; ///< stable: the session's key and the command line's --id; --plugin-id if that is the program's
    std::string label{};
    std::string explanation{}; ///< one sentence, for tooltips and --help
    std::string unit{};        ///< "%", "points" ..., empty if none
    ParameterValue defaultValue{};
    double minimum = 0;                 ///< of numbers
    double maximum = 0;                 ///< of numbers; not above minimum means unbounded
    std::vector<std::string> choices{}; ///< of strings; empty means free text
    std::vector<std::string> words{}; ///< of free texts: those that are words, which forms show in the user's language
    /// Of strings that are lists, else 0: what separates their entries. On the command line, entries may also be given
    /// one at a time; the list's option is then called by its id without the plural s.
    char separator = 0;
    /// Of strings and own values: why a text is no use, for the user, or empty. May be missing. Quick, any thread.
    std::function<Message(const std::string& text)> mistake{};
    /// Elsewhere it is not looked at, and forms hide it.
    ParameterCondition onlyWith{};
    ParameterCondition orWith{}; ///< beside `onlyWith`, another one that is enough; without an id none
};

/// Whether a parameter matters beside the `values` of all `parameters`; also if it depends on what is not known.
/// `followed`: how many conditions led to this one, of which there are as many as parameters at most.
inline bool matters(const Parameter& parameter, const std::vector<Parameter>& parameters, const ParameterValues& values,
                    std::size_t followed = 0)
{
    const auto holds = [&](const ParameterCondition& condition) {
        const auto isMet = [&](const ParameterValue& value) {
            return std::ranges::find(condition.values, value) != condition.values.end();
        };
        const auto known = std::ranges::find(parameters, condition.id, &Parameter::id);
        const bool isKnown = known != parameters.end();
        if (isKnown && followed < parameters.size() && !matters(*known, parameters, values, followed + 1))
            return false;
        if (const auto found = values.find(condition.id); found != values.end())
            return isMet(found->second);
        return condition.id.empty() || !isKnown || isMet(known->defaultValue);
    };
    return holds(parameter.onlyWith) || (!parameter.orWith.id.empty() && holds(parameter.orWith));
}

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
