// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/plugin_options.h"

#include "core/base/mapped_file.h"
#include "core/base/text.h"
#include "plugins/host/file_saving.h"
#include "plugins/host/parameter_text.h"

#include <tan/transfer.h>

#include <algorithm>
#include <filesystem>

namespace tetra {
namespace {

/// The name of a plugin's option that would have one of the program's.
std::string namedAsPlugins(const std::string& name)
{
    return "plugin-" + name;
}

bool isSwitch(const Parameter& parameter)
{
    return std::holds_alternative<bool>(parameter.defaultValue);
}

bool isOnByDefault(const Parameter& parameter)
{
    return isSwitch(parameter) && std::get<bool>(parameter.defaultValue);
}

bool isIsovalues(const Parameter& parameter)
{
    return std::holds_alternative<std::vector<Isovalue>>(parameter.defaultValue);
}

bool isTransferFunction(const Parameter& parameter)
{
    return std::holds_alternative<TransferFunction>(parameter.defaultValue);
}

bool isList(const Parameter& parameter)
{
    return isIsovalues(parameter) || parameter.separator != 0;
}

std::string optionName(const Parameter& parameter)
{
    if (isOnByDefault(parameter))
        return "no-" + parameter.id;
    if (isList(parameter) && parameter.id.ends_with('s'))
        return parameter.id.substr(0, parameter.id.size() - 1);
    return parameter.id;
}

/// Under which name the arguments hold the parameter.
std::string optionName(const Arguments& arguments, const Parameter& parameter)
{
    if (isOnByDefault(parameter) && arguments.has(parameter.id) && !arguments.ownOptions.contains(parameter.id))
        return parameter.id; // said, though it is usual
    const std::string name = optionName(parameter);
    return arguments.ownOptions.contains(name) ? namedAsPlugins(name) : name;
}

std::string placeholder(const Parameter& parameter)
{
    if (isSwitch(parameter))
        return "";
    if (isIsovalues(parameter))
        return "V[:COLOUR[:OPACITY]]";
    if (isTransferFunction(parameter))
        return "FILE";
    if (!parameter.choices.empty()) {
        std::string choices;
        for (const std::string& choice : parameter.choices)
            choices += (choices.empty() ? "" : "|") + choice;
        return choices;
    }
    if (std::holds_alternative<Colour>(parameter.defaultValue))
        return "COLOUR";
    if (std::holds_alternative<Eigen::Vector3d>(parameter.defaultValue))
        return "X,Y,Z";
    const bool isText = std::holds_alternative<std::string>(parameter.defaultValue) ||
                        std::holds_alternative<OwnValue>(parameter.defaultValue);
    return isText ? "TEXT" : "NUMBER";
}

std::string startingSmall(std::string text)
{
    if (!text.empty())
        text[0] = smallLetter(text[0]);
    return text;
}

Option optionOf(const Parameter& parameter)
{
    Option option{.name = optionName(parameter),
                  .placeholder = placeholder(parameter),
                  .explanation = parameter.explanation,
                  .repeatable = isList(parameter),
                  .ofPlugin = true};
    if (isOnByDefault(parameter))
        option.explanation = "Turns off what is done by default: " + startingSmall(option.explanation);
    if (isIsovalues(parameter))
        option.explanation +=
            " V is in data units, or like 2.5sd in standard deviations above the mean. COLOUR is #rrggbb "
            "or a name (orange, silver ...), OPACITY above 0 and at most 1.";
    if (isTransferFunction(parameter)) {
        option.explanation += " A file that TAn saved, or a ParaView preset (the manual, 'Files').";
        option.byDefault = "one that fits the data";
    } else if (!isSwitch(parameter) && !isList(parameter))
        option.byDefault = parameterText(parameter.defaultValue);
    if (!parameter.unit.empty())
        option.explanation += " In " + parameter.unit + ".";
    return option;
}

/// The first of the file, completed as the window does it. Errors name the file, and the line and the column of what is
/// wrong in it.
Result<ParameterValue> readTransferFunction(const std::string& path, const TransferFunction& usual,
                                            const std::optional<ValueRange>& range, std::vector<Message>* remarks)
{
    constexpr std::size_t largestFile = 16 << 20;
    const auto text = wholeText(path, largestFile);
    if (!text)
        return Error{text.error().kind, "The transfer function cannot be used. " + text.error().text()};
    ImportContext context{usual};
    if (range)
        context.limits = TransferLimits{range->minimum, range->maximum};
    auto functions = importTransferFunctions(*text, context);
    if (!functions)
        return Error{ErrorKind::BadInput, "'" + path + "': " + functions.error().text()};
    if (functions->front().spread && remarks != nullptr)
        remarks->push_back(Message::say("'%1' covers 0 to 1, and is stretched over the values of the data, %2 to %3.",
                                        path, formatNumber(range->minimum), formatNumber(range->maximum)));
    return ParameterValue(std::move(functions->front().function));
}

/// Whether something of a message is `name`.
bool names(const Message& message, const std::string& name)
{
    const auto& arguments = message.arguments();
    return arguments.empty()
               ? message.text() == name
               : std::ranges::any_of(arguments, [&](const Message& argument) { return names(argument, name); });
}

/// With the option, unless the error speaks of it already, and with what a value that does not fit would mean.
Error ofOption(const Error& error, const Parameter& parameter, const std::string& name)
{
    if (!names(error.message, "--" + name))
        return {error.kind, "'--" + name + "': " + error.text()};
    return parameter.explanation.empty() ? error : Error{error.kind, error.text() + " " + parameter.explanation};
}

Result<ParameterValue> parseOption(const Arguments& arguments, const Parameter& parameter, const std::string& name,
                                   const std::optional<ValueRange>& range, std::vector<Message>* remarks)
{
    if (isSwitch(parameter))
        return ParameterValue(!isOnByDefault(parameter) || name == parameter.id);
    if (isTransferFunction(parameter))
        return readTransferFunction(*arguments.value(name), std::get<TransferFunction>(parameter.defaultValue), range,
                                    remarks);
    const char separator = parameter.separator != 0 ? parameter.separator : ',';
    std::string text;
    for (const std::string& value : arguments.values(name)) {
        if (!text.empty())
            text += separator;
        text += value;
    }
    Parameter named = parameter;
    named.id = "--" + name; // what errors call it
    return parseParameter(named, text);
}

} // namespace

void addPluginOptions(Syntax& syntax, const std::vector<Parameter>& parameters)
{
    for (const Parameter& parameter : parameters) {
        const Option option = optionOf(parameter);
        if (isOnByDefault(parameter))
            syntax.usualSwitches.push_back(parameter.id);
        const auto same = std::ranges::find_if(
            syntax.options, [&](const Option& one) { return one.ofPlugin && one.name == option.name; });
        if (same == syntax.options.end())
            syntax.options.push_back(option);
        else if (same->explanation.find(option.explanation) == std::string::npos)
            same->explanation += " " + option.explanation; // of another plugin, which says so
    }
}

void sayDefaultsFromData(Syntax& syntax, const std::vector<Parameter>& parameters, const std::vector<Parameter>& others)
{
    for (const Parameter& parameter : parameters) {
        const auto other = std::ranges::find(others, parameter.id, &Parameter::id);
        if (other == others.end() || other->defaultValue == parameter.defaultValue)
            continue;
        const std::string name = optionName(parameter);
        for (Option& option : syntax.options)
            if (option.ofPlugin && option.name == name && !option.byDefault.empty() && !isTransferFunction(parameter))
                option.byDefault = "from the data";
    }
}

void separatePluginOptions(Syntax& syntax)
{
    const auto own = ownOptionNames(syntax);
    for (Option& option : syntax.options)
        if (option.ofPlugin && own.contains(option.name))
            option.name = namedAsPlugins(option.name);
}

Result<ParameterValues> pluginValues(const Arguments& arguments, const std::vector<Parameter>& parameters,
                                     const std::optional<ValueRange>& range, std::vector<Message>* remarks)
{
    ParameterValues values;
    for (const Parameter& parameter : parameters) {
        const std::string name = optionName(arguments, parameter);
        if (!arguments.has(name))
            continue;
        const auto value = parseOption(arguments, parameter, name, range, remarks);
        if (!value)
            return ofOption(value.error(), parameter, name);
        values[parameter.id] = *value;
    }
    return values;
}

OptionOfParameter optionNames(const Arguments& arguments)
{
    return [&arguments](const Parameter& parameter) { return "--" + optionName(arguments, parameter); };
}

Status checkPluginOptions(const Arguments& arguments, const std::vector<Parameter>& all,
                          const std::vector<Parameter>& used, const std::string& owner)
{
    for (const Parameter& parameter : all) {
        const std::string name = optionName(arguments, parameter);
        if (arguments.has(name) && std::ranges::find(used, parameter.id, &Parameter::id) == used.end())
            return Error{ErrorKind::WrongUsage, "The " + owner + " has no option '--" + name + "'."};
    }
    return {};
}

std::string fileChoices(PluginHost& host, WrittenContent content)
{
    std::string choices;
    for (const std::string& ending : writableEndings(host, content))
        choices += (choices.empty() ? "FILE" : "|") + ending;
    return choices.empty() ? "FILE" : choices;
}

} // namespace tetra
