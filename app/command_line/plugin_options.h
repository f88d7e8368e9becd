// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/arguments.h"
#include "plugins/api/parameter.h"
#include "plugins/host/parameter_values.h"
#include "plugins/host/plugin_host.h"

#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// The parameters of all these plugins: which one will be used is known only when the input is.
template <class Interface> std::vector<Parameter> allParameters(const std::vector<Provided<Interface>>& plugins)
{
    std::vector<Parameter> all;
    for (const auto& provided : plugins)
        for (Parameter& parameter : provided.plugin->parameters())
            all.push_back(std::move(parameter));
    return all;
}

/// "one|another", for the help.
template <class Interface> std::string idChoices(const std::vector<Provided<Interface>>& plugins)
{
    std::string ids;
    for (const auto& provided : plugins)
        ids += (ids.empty() ? "" : "|") + provided.id;
    return ids.empty() ? "ID" : ids;
}

/// Adds an option for each parameter, unless another plugin's of that name is there already: "--id VALUE"; "--id" for a
/// truth value that is false by default, "--no-id" for one that is true, where "--id" is taken, too; one option a time,
/// repeated, for isovalues
/// ("--isovalue" for the parameter "isovalues"); "--id FILE" for a transfer function.
void addPluginOptions(Syntax& syntax, const std::vector<Parameter>& parameters);

/// Says of options whose parameter has one default in `parameters` and another one in `others`, which are the same
/// plugins' for other data, that the data tell it. Before separatePluginOptions().
void sayDefaultsFromData(Syntax& syntax, const std::vector<Parameter>& parameters,
                         const std::vector<Parameter>& others);

/// An option keeps the name that the program gives it: one of a plugin that has the same becomes "--plugin-NAME". To be
/// called when all options are there.
void separatePluginOptions(Syntax& syntax);

/// The values that the arguments give to these parameters. A file with a transfer function is read as the window reads
/// it: presets from 0 to 1 are stretched over `range`, that of the data, and what a preset lacks is that of the
/// parameter's default. `remarks`, if given, gets sentences on what became of files. The error names the option and
/// what it takes.
Result<ParameterValues> pluginValues(const Arguments& arguments, const std::vector<Parameter>& parameters,
                                     const std::optional<ValueRange>& range = {},
                                     std::vector<Message>* remarks = nullptr);

/// The names that these arguments have for parameters, with the hyphens. The arguments outlive it.
OptionOfParameter optionNames(const Arguments& arguments);

/// An error (WrongUsage) if the arguments hold an option made from one of the parameters in `all` that is not one of
/// those in `used`. `owner` is whose parameters those are: "builder 'refinement'".
Status checkPluginOptions(const Arguments& arguments, const std::vector<Parameter>& all,
                          const std::vector<Parameter>& used, const std::string& owner);

/// "FILE.obj|.ply ...": a placeholder with the endings under which such content can be written.
std::string fileChoices(PluginHost& host, WrittenContent content);

} // namespace tetra
