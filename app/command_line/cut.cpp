// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/model_input.h"
#include "app/command_line/option_values.h"
#include "app/command_line/subcommands.h"
#include "app/command_line/table.h"
#include "core/base/text.h"
#include "core/build/model_build.h"
#include "plugins/host/output_check.h"

#include <tan/packed.h>

#include <array>

/// `tan cut` and `tan unpack`: a model, or its coarse levels, as an explicit file.
namespace tetra {
namespace {

Result<Outcome> copyInput(const Invocation& invocation, const std::optional<Accuracy>& accuracy)
{
    const std::filesystem::path input = invocation.arguments.positionals[0];
    const std::filesystem::path output = *invocation.arguments.value("output");
    if (const Status distinct = checkOutput(output, std::array{input}); !distinct)
        return distinct.error();
    if (const Status safe = checkModelOutput(output); !safe)
        return safe.error();
    const auto token = tokenOption(invocation.arguments, input);
    if (!token)
        return token.error();
    const auto report = copyModel(input.string(), accuracy, output, invocation.progress, *token);
    if (!report)
        return report.error();
    Outcome outcome;
    outcome.figures = {{"model", output.string()},
                       {"sites", report->sites},
                       {"of_sites", report->sitesOfWhole},
                       {"tetrahedra", report->tetrahedra},
                       {"bytes", report->fileBytes}};
    outcome.text = visibleText(output.string()) + ": " + std::to_string(report->sites) +
                   (report->sites == report->sitesOfWhole ? "" : " of " + std::to_string(report->sitesOfWhole)) +
                   " sites, " + std::to_string(report->tetrahedra) + " tetrahedra in the history, " +
                   byteText(report->fileBytes) + "\n";
    if (report->derived.empty())
        return outcome;
    JsonArray derived;
    std::string names;
    for (const std::string& section : report->derived) {
        derived.push_back(section);
        names += (names.empty() ? "" : ", ") + visibleText(section);
    }
    outcome.figures["derived"] = derived;
    outcome.text += "Rebuilt by this version, and not byte for byte what was packed: " + names + ".\n";
    return outcome;
}

/// --error and --warping, if either is given.
Result<std::optional<Accuracy>> limitsOf(const Arguments& arguments, const std::string& input, const Progress& progress)
{
    if (!arguments.has("error") && !arguments.has("warping"))
        return std::optional<Accuracy>();
    const auto accuracy = accuracyOption(arguments);
    if (!accuracy)
        return accuracy.error();
    if (!arguments.has("warping"))
        return std::optional(*accuracy);
    const auto token = tokenOption(arguments, input);
    if (!token)
        return token.error();
    const auto facts = modelFacts(input, progress, *token);
    if (!facts)
        return facts.error();
    if (const Status warps = checkWarpingOption(arguments, facts->description, input); !warps)
        return warps.error();
    return std::optional(*accuracy);
}

Option limitOption(Option option, bool required)
{
    option.byDefault = {};
    option.required = required;
    return option;
}

} // namespace

Syntax cutSyntax(PluginHost&)
{
    return {.purpose = "write the coarse levels of a model as a smaller one",
            .explanation = "The new model has the meshes of the old one up to the requested accuracy, and nothing "
                           "finer: to share, to send, or to keep of a model that is too large. It is complete in "
                           "itself, and 'tan verify' proves it against the same data.",
            .positionals = {{"MODEL", modelExplanation()}},
            .options = {limitOption(errorOption(), true), limitOption(warpingOption(), false),
                        outputOption("FILE", "The model to write, conventionally *.tan."), tokenFileOption()},
            .examples = {{"tan cut engine.tan --error 1 -o engine-1.tan", "All meshes down to an error of 1 %."},
                         {"tan cut https://example.org/engine.tan --error 4 -o engine-4.tan",
                          "From a model on a server; only that much is fetched."}}};
}

Result<Outcome> runCut(const Invocation& invocation)
{
    const auto limits =
        limitsOf(invocation.arguments, invocation.arguments.positionals[0], invocation.progress.part(0, 0));
    return limits ? copyInput(invocation, *limits) : limits.error();
}

Syntax unpackSyntax(PluginHost&)
{
    return {.purpose = "write a packed model as an ordinary one",
            .explanation = "The result is the model that was packed, byte for byte; if a later version of TAn makes "
                           "some part of it differently, a message says so. With an accuracy only the beginning is "
                           "unpacked, in a fraction of the time.",
            .positionals = {{"PACKED", "The packed model: a file, or its address on a server (http:// or https://)."}},
            .options = {limitOption(errorOption(), false), limitOption(warpingOption(), false),
                        outputOption("FILE", "The model to write, conventionally *.tan."), tokenFileOption()},
            .examples = {{"tan unpack engine.packed.tan -o engine.tan", "All of it."},
                         {"tan unpack engine.packed.tan --error 2 -o engine-2.tan", "Down to an error of 2 %."}}};
}

Result<Outcome> runUnpack(const Invocation& invocation)
{
    const std::string& input = invocation.arguments.positionals[0];
    const auto token = tokenOption(invocation.arguments, input);
    if (!token)
        return token.error();
    const auto facts = modelFacts(input, invocation.progress.part(0, 0), *token);
    if (!facts)
        return facts.error();
    if (facts->form != ModelForm::Packed)
        return Error{ErrorKind::WrongUsage,
                     "'" + input +
                         "' is not packed: every command accepts it as it is. 'tan cut' writes its coarse levels."};
    const auto limits = limitsOf(invocation.arguments, input, invocation.progress.part(0, 0));
    return limits ? copyInput(invocation, *limits) : limits.error();
}

} // namespace tetra
