// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/building/parts.h"

#include "app/command_line/building/build_outcome.h"
#include "app/command_line/datasets.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/table.h"
#include "core/base/memory.h"
#include "core/base/text.h"
#include "plugins/host/parameter_text.h"
#include "plugins/host/parts/part_building.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

namespace tetra {
namespace {

constexpr std::string_view prepareWord = "prepare";

struct PartWords {
    std::uint32_t number = 1;
    std::uint32_t count = 1;
};

/// Of "3/8".
Result<PartWords> partWords(const std::string& text)
{
    const std::size_t slash = text.find('/');
    const auto number = parseNumber<std::uint32_t>(text.substr(0, slash));
    const auto count = slash == std::string::npos ? std::nullopt : parseNumber<std::uint32_t>(text.substr(slash + 1));
    if (!number || !count || *number < 1 || *number > *count)
        return Error{ErrorKind::WrongUsage, "'" + text +
                                                "' names no part. '--part' takes \"prepare\", and then the number of a "
                                                "part and how many there are, such as 3/8."};
    return PartWords{*number, *count};
}

/// What only a build as a whole can do.
Status checkCombination(const Arguments& arguments)
{
    for (const char* option : {"keep", "packed", "resume"})
        if (arguments.has(option))
            return Error{ErrorKind::WrongUsage,
                         std::string("'--") + option + "' cannot be combined with '--part': " +
                             (std::string_view(option) == "resume" ? "a part always goes on where it was stopped."
                                                                   : "a part is no model yet.") +
                             " Leave it out."};
    return {};
}

Result<Outcome> prepare(const Invocation& invocation, const std::string& input, const std::string& folder)
{
    const Arguments& arguments = invocation.arguments;
    auto imported = importOptions(invocation, input);
    if (!imported)
        return imported.error();
    const auto builders = invocation.host.builders();
    std::vector<Parameter> parameters = allParameters(builders);
    if (const auto id = arguments.value("builder")) {
        const auto builder = invocation.host.builder(*id);
        if (!builder)
            return builder.error();
        parameters = builder->plugin->parameters();
        if (const Status known =
                checkPluginOptions(arguments, allParameters(builders), parameters, "builder '" + *id + "'");
            !known)
            return known.error();
    }
    const auto values = pluginValues(arguments, parameters);
    if (!values)
        return values.error();
    const auto prepared = prepareParts(invocation.host, input, toKeep(*std::move(imported), arguments),
                                       arguments.value("builder"), *values, folder, invocation.progress);
    if (!prepared)
        return prepared.error();
    const PartsPlan* const plan = &prepared->plan;
    Outcome outcome;
    outcome.figures = {{"folder", folder},
                       {"builder", plan->builder},
                       {"blocks", plan->blocks},
                       {"points", plan->lattice.pointCount()},
                       {"reads_only_its_blocks", plan->readsOnlyItsBlocks()},
                       {"peak_bytes", peakResidentBytes()}};
    outcome.text = visibleText(folder) + ": " + std::to_string(plan->blocks) + " blocks, to be built by " +
                   visibleText(plan->builder) + " in at most as many parts\n";
    if (plan->domain == DomainClass::Curvilinear)
        outcome.text += "Each part will read all of '" + visibleText(input) +
                        "', as the places of its points are read as a whole.\n";
    else if (plan->samples && !plan->readsOnlyItsBlocks())
        outcome.text += "Each part will read all of '" + visibleText(input) + "', as it weighs all points.\n";
    else if (!plan->samples)
        outcome.text += "Each part will read all of '" + visibleText(input) +
                        "', as its samples are not stored as they are used. From a raw file, an uncompressed NRRD, a "
                        "NumPy array or a VTI file with raw appended data, a part reads only its own blocks.\n";
    addRemarks(prepared->dataset, outcome);
    return outcome;
}

Error preparedOtherwise(const std::string& folder, const std::string& what)
{
    return {ErrorKind::WrongUsage, "The build in '" + folder + "' was prepared " + what +
                                       ". Give a part the same options as the preparation, or none."};
}

/// That options given to a part are those of the preparation.
Status checkSame(const Invocation& invocation, const PartsPlan& plan, const std::string& folder)
{
    const Arguments& arguments = invocation.arguments;
    std::error_code problem;
    const std::string& input = arguments.positionals[0];
    if (!std::filesystem::equivalent(input, plan.input, problem))
        return Error{ErrorKind::WrongUsage, "The build in '" + folder + "' was prepared for '" + plan.input.string() +
                                                "', and this is '" + input + "'."};
    if (const auto builder = arguments.value("builder"); builder && *builder != plan.builder)
        return preparedOtherwise(folder, "for the builder '" + plan.builder + "'");
    const auto builder = invocation.host.builder(plan.builder);
    if (!builder)
        return builder.error();
    const auto parameters = builder->plugin->parameters();
    if (const Status known = checkPluginOptions(arguments, allParameters(invocation.host.builders()), parameters,
                                                "builder '" + plan.builder + "'");
        !known)
        return known.error();
    const auto values = pluginValues(arguments, parameters);
    if (!values)
        return values.error();
    for (const auto& [id, value] : *values)
        if (std::ranges::find(plan.parameters, std::pair(id, parameterText(value))) == plan.parameters.end())
            return preparedOtherwise(folder, "with another value of '--" + id + "'");
    const auto imported = importOptions(invocation, input);
    if (!imported)
        return imported.error();
    for (const auto& text : importTexts(toKeep(*imported, arguments)))
        if (std::ranges::find(plan.imported, text) == plan.imported.end())
            return preparedOtherwise(folder, "with other options for reading");
    return {};
}

Result<Outcome> build(const Invocation& invocation, const PartWords& part, const std::string& folder)
{
    const auto plan = readPlan(folder);
    if (!plan)
        return plan.error();
    if (const Status same = checkSame(invocation, *plan, folder); !same)
        return same.error();
    const bool waits = invocation.arguments.has("wait");
    if (waits && plan->domain == DomainClass::RegularLattice)
        return Error{ErrorKind::WrongUsage, "Parts of a regular lattice wait for nothing. Leave '--wait' out."};
    const auto built = buildPart(invocation.host, folder, part.number, part.count, waits, invocation.progress);
    if (!built && built.error().kind == ErrorKind::Cancelled)
        return Error{ErrorKind::Cancelled, built.error().text() + " What is done is kept in '" + printable(folder) +
                                               "': the same command continues from there."};
    if (!built)
        return built.error();
    Outcome outcome;
    outcome.figures = {{"folder", folder},
                       {"part", part.number},
                       {"parts", part.count},
                       {"builder", plan->builder},
                       {"sites", built->sites},
                       {"tetrahedra", built->tetrahedra},
                       {"finished_before", built->wasFinished},
                       {"seconds", built->seconds},
                       {"peak_bytes", built->peakBytes}};
    const std::string name = "Part " + std::to_string(part.number) + " of " + std::to_string(part.count);
    const std::string size =
        std::to_string(built->sites) + " sites, " + std::to_string(built->tetrahedra) + " tetrahedra in the history";
    outcome.text = built->wasFinished ? name + " was finished already: " + size + "\n"
                                      : name + ": " + size + ", in " + rounded(built->seconds, 3) +
                                            " s, using at most " + byteText(built->peakBytes) + " of memory\n";
    if (part.count > plan->blocks)
        outcome.text += "There are " + std::to_string(plan->blocks) + " blocks, so that " +
                        std::to_string(part.count - plan->blocks) + " parts of so many have none.\n";
    return outcome;
}

} // namespace

Option partOption()
{
    return {.name = "part",
            .placeholder = "prepare|I/N",
            .explanation = "Share the build of a regular lattice or a curvilinear grid, refined in blocks, among "
                           "processes, on one machine or on many that see one disk: 'prepare' goes through the dataset "
                           "once and makes the folder that '-o' names, with all options of the build; then I/N, such "
                           "as 3/8, builds part I of N into that folder, in any order and at any time, and goes on "
                           "where it was stopped; at last 'tan merge' makes the model. It is the same, byte for byte, "
                           "as one built by a single process with the same blocks ('--block 32' unless another edge "
                           "is given)."};
}

Option waitOption()
{
    return {.name = "wait",
            .placeholder = "",
            .explanation =
                "With --part I/N of a curvilinear grid: wait for what other parts find out about common faces, "
                "which have to be built at the same time. Without it the exit code is 5, and the same "
                "command goes on later."};
}

Result<Outcome> runPart(const Invocation& invocation, const std::string& part)
{
    const Arguments& arguments = invocation.arguments;
    if (const Status possible = checkCombination(arguments); !possible)
        return possible.error();
    const std::string& input = arguments.positionals[0];
    const std::string folder = *arguments.value("output");
    if (part == prepareWord && arguments.has("wait"))
        return Error{ErrorKind::WrongUsage, "The preparation waits for nothing. Leave '--wait' out."};
    if (part == prepareWord)
        return prepare(invocation, input, folder);
    const auto words = partWords(part);
    return words ? build(invocation, *words, folder) : words.error();
}

} // namespace tetra
