// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/building/build_outcome.h"
#include "app/command_line/building/pack.h"
#include "app/command_line/building/parts.h"
#include "app/command_line/datasets.h"
#include "app/command_line/error_statistics.h"
#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/subcommands.h"
#include "core/base/work_folder.h"
#include "core/build/model_build.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/model_building.h"
#include "plugins/host/output_check.h"
#include "plugins/host/parameter_values.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <iterator>
#include <ranges>
#include <utility>
#include <vector>

namespace tetra {
namespace {

constexpr std::string_view usualBlock = "32";

/// Before anything long is done.
Status checkOutputs(const std::filesystem::path& input, const std::filesystem::path& output)
{
    if (const Status distinct = checkOutput(output, std::array{input}); !distinct)
        return distinct;
    return checkModelOutput(output);
}

/// What was built into what was asked for.
Status pack(const std::filesystem::path& built, const std::filesystem::path& output, const Progress& progress,
            Outcome& outcome)
{
    const auto model = Model::open(built);
    if (!model)
        return model.error();
    const auto report = packModel(**model, output, progress);
    if (!report)
        return report.error();
    addPacking(*report, (*model)->fileSize(), outcome);
    outcome.figures["bytes"] = report->fileBytes;
    return {};
}

std::string optionInQuotes(std::string_view option)
{
    return "'--" + std::string(option) + "'";
}

/// Those that would build the dataset and know all options that are given, the most suitable first.
std::vector<Provided<Builder>> buildersThatKnow(const Arguments& arguments, PluginHost& host, const Dataset& dataset)
{
    std::vector<std::pair<double, Provided<Builder>>> found;
    for (auto& builder : host.builders())
        if (checkPluginOptions(arguments, allParameters(host.builders()), builder.plugin->parameters(), {}))
            if (const double score = builder.plugin->accepts(dataset).score; score > 0)
                found.emplace_back(score, std::move(builder));
    std::ranges::stable_sort(found, std::greater(), [](const auto& scored) { return scored.first; });
    std::vector<Provided<Builder>> builders;
    std::ranges::move(found | std::views::values, std::back_inserter(builders));
    return builders;
}

/// The builder that is named; else the one that suits the dataset best, of those that know the options.
Result<Provided<Builder>> builderFor(const Dataset& dataset, const Arguments& arguments, PluginHost& host)
{
    const auto named = arguments.value("builder");
    auto builder = chooseBuilder(host, dataset, named);
    if (!builder)
        return builder;
    const Status known = checkPluginOptions(arguments, allParameters(host.builders()), builder->plugin->parameters(),
                                            "builder '" + builder->id + "'");
    if (known)
        return builder;
    auto others = buildersThatKnow(arguments, host, dataset);
    if (!named && !others.empty())
        return std::move(others.front());
    std::string choices;
    for (const Provided<Builder>& other : others)
        choices += (choices.empty() ? ", or build with " : " or ") + optionInQuotes("builder " + other.id);
    return Error{known.error().kind, known.error().text() + " Leave it out" + choices + "."};
}

/// What a build would be able to do in blocks, if its builder knows them.
BuildAbilities abilitiesInBlocks(const Builder& builder, const Dataset& dataset, ParameterValues values)
{
    values["block"] = std::string(usualBlock);
    if (!checkParameterValues({}, builder.parameters(), values) || !checkOfUse(builder.parameters(), values, dataset))
        return {.keeps = false};
    return builder.abilities(dataset, values);
}

/// Options that ask for what this build cannot do.
Status checkAbilities(const Arguments& arguments, const Provided<Builder>& builder, const Dataset& dataset,
                      const ParameterValues& values)
{
    const BuildAbilities abilities = builder.plugin->abilities(dataset, values);
    const std::string build = "This build of '" + dataset.source.name + "' by '" + builder.id + "'";
    if (arguments.has("resume") && !abilities.resumes)
        return Error{ErrorKind::WrongUsage, build + " cannot be resumed. Leave '--resume' out."};
    if (arguments.has("keep") && !abilities.keeps)
        return Error{ErrorKind::WrongUsage, build + " has no mesh before it ends. Leave '--keep' out" +
                                                (abilities.resumes ? "; '--resume' continues it later." : ".")};
    return {};
}

/// Where the model lies until it is packed.
Result<std::optional<WorkFolder>> packingFolder(const std::string& output, const Arguments& arguments)
{
    auto folder = WorkFolder::open(output + ".packing", arguments.has("resume") ? WorkFolder::Leftovers::Keep
                                                                                : WorkFolder::Leftovers::Remove);
    if (!folder)
        return folder.error();
    return std::optional<WorkFolder>(*std::move(folder));
}

/// A builder, and what the options ask of it.
struct WayToBuild {
    Provided<Builder> builder;
    ParameterValues values;
};

Result<WayToBuild> wayToBuild(const Dataset& dataset, const Arguments& arguments, Result<Provided<Builder>> builder)
{
    if (!builder)
        return builder.error();
    const auto parameters = builder->plugin->parameters();
    auto values = pluginValues(arguments, parameters);
    if (!values)
        return values.error();
    if (const Status used = checkOfUse(parameters, *values, dataset, optionNames(arguments)); !used)
        return used.error();
    if (const Status able = checkAbilities(arguments, *builder, dataset, *values); !able)
        return able.error();
    return WayToBuild{*std::move(builder), *std::move(values)};
}

/// Where the builder was TAn's choice, and only met while it built what it has no use for, as a grid that crosses
/// itself is no mesh: the next most suitable way.
std::optional<WayToBuild> wayAfter(const Result<ModelBuild>& build, const WayToBuild& tried, const Dataset& dataset,
                                   const Arguments& arguments, PluginHost& host)
{
    if (build.ok() || build.error().kind != ErrorKind::BadInput || arguments.has("builder"))
        return std::nullopt;
    for (Provided<Builder>& builder : buildersThatKnow(arguments, host, dataset))
        if (builder.id != tried.builder.id)
            if (auto way = wayToBuild(dataset, arguments, std::move(builder)))
                return *std::move(way);
    return std::nullopt;
}

/// Of a build with '--resume': where what is done lies.
Error withWayOn(const Error& error, const std::filesystem::path& workFolder)
{
    std::error_code problem;
    if (error.kind != ErrorKind::Cancelled || !std::filesystem::exists(workFolder, problem))
        return error;
    return {error.kind, error.text() + " What is done is kept in '" + printable(workFolder.string()) +
                            "': the same command continues from there."};
}

/// Tells if threads were asked for that the build had no use for.
void tellThreads(const Arguments& arguments, int threads, const Provided<Builder>& builder, const Dataset& dataset,
                 const ParameterValues& values, Outcome& outcome)
{
    const bool usesThreads = builder.plugin->abilities(dataset, values).usesThreads;
    const std::size_t allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    outcome.figures["threads"] = usesThreads ? allowed : 1;
    if (!arguments.has("threads") || threads == 1 || usesThreads)
        return;
    outcome.text += "One thread was used: such a build cannot use more.";
    if (abilitiesInBlocks(*builder.plugin, dataset, values).usesThreads)
        outcome.text += " In blocks it can: " + optionInQuotes("block " + std::string(usualBlock)) + ".";
    outcome.text += "\n";
}

/// Whatever is built, reading and checking may use them, too.
Option buildThreadsOption()
{
    Option option = threadsOption();
    option.explanation += " Only refinement in blocks can use more than one.";
    return option;
}

} // namespace

Syntax buildSyntax(PluginHost& host)
{
    Syntax syntax{
        .purpose = "build a multiresolution model from a dataset",
        .explanation = "The model holds the whole history of the mesh, from coarse to fine, so that any accuracy can "
                       "be extracted later without building again. The file appears when it is complete; if the build "
                       "is cancelled or fails, nothing is left (but see --keep and --resume) and an older model of "
                       "that name is not changed. Until then all files of the build are in the folder MODEL.work.",
        .positionals = {{"IN", "The dataset: " + std::string("a file that one of the readers supports.")}},
        .options =
            {outputOption("MODEL", "The model to write, conventionally *.tan."),
             {.name = "builder",
              .placeholder = idChoices(host.builders()),
              .explanation = "Builder plugin.",
              .byDefault = "the one that suits the dataset best"},
             {.name = "keep",
              .placeholder = "",
              .explanation =
                  "If the build is interrupted, keep what is finished: from refinement as a model of lower accuracy, "
                  "from decimation as one without the coarser meshes. It does not replace an existing MODEL, but is "
                  "kept next to it under a name with its error, such as engine-25-percent.tan. A build in blocks "
                  "refines all of them coarsely first, which takes about a tenth more time, and keeps that."},
             {.name = "packed",
              .placeholder = "",
              .explanation = "Write a packed model, as 'tan pack' does; until it is packed, the model itself is in the "
                             "folder MODEL.packing."},
             partOption(),
             waitOption(),
             buildThreadsOption(),
             {.name = "resume",
              .placeholder = "",
              .explanation = "Continue an interrupted build of the same model, from the same data and with the same "
                             "options, if there is one; the result is the same. If this build is interrupted, it can "
                             "be continued in turn: use this option from the start of a long build."}},
        .examples = {{"tan build engine.nrrd -o engine.tan", "Everything, down to an error of 0."},
                     {"tan build engine.nrrd --error 0.5 -o engine.tan", "A smaller model, exact to 0.5 %."},
                     {"tan build engine.nrrd --region 0,0,32,255,255,95 --stride 2,2,1 -o middle.tan",
                      "A part of the data, more coarsely."},
                     {"tan build engine.nrrd --error 0.5 --part prepare -o engine.parts",
                      "Share a build among processes: first this,"},
                     {"tan build engine.nrrd --part 3/8 -o engine.parts",
                      "then each part, in any order, and at last 'tan merge engine.parts -o engine.tan'."},
                     {"tan build flow.vtu --array nut --scale log:1e-9 -o nut.tan",
                      "Values spanning many powers of ten: errors are factors."}}};
    addPluginOptions(syntax, allParameters(host.builders()));
    addImportOptions(syntax, host);
    syntax.exitCodes = {0, 2, 3, 4, 5, 130};
    return syntax;
}

Result<Outcome> runBuild(const Invocation& invocation)
{
    const Arguments& arguments = invocation.arguments;
    const std::string& input = arguments.positionals[0];
    const std::string output = *arguments.value("output");
    const auto threads = threadsOf(arguments);
    if (!threads)
        return threads.error();
    std::optional<tbb::global_control> limit;
    if (*threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(*threads));
    if (const auto part = arguments.value("part"))
        return runPart(invocation, *part);
    if (arguments.has("wait"))
        return Error{ErrorKind::WrongUsage, "'--wait' is for parts. Leave it out, or give '--part' as well."};
    if (const Status safe = checkOutputs(input, output); !safe)
        return safe.error();
    if (arguments.has("packed") && arguments.has("keep"))
        return Error{ErrorKind::WrongUsage, "'--keep' and '--packed' cannot be combined: what an interrupted build "
                                            "keeps can be packed with 'tan pack'. Leave one of the two out."};

    auto imported = importOptions(invocation, input);
    if (!imported)
        return imported.error();
    const bool logarithmic = imported->scale.logarithmic; // what was imported goes with the build
    const auto dataset = openDataset(invocation.host, input, *imported, invocation.progress.part(0, 0.05));
    if (!dataset)
        return dataset.error();
    auto way = wayToBuild(*dataset, arguments, builderFor(*dataset, arguments, invocation.host));
    if (!way)
        return way.error();
    const bool isPacked = arguments.has("packed");
    auto packing = isPacked ? packingFolder(output, arguments) : Result<std::optional<WorkFolder>>(std::nullopt);
    if (!packing)
        return packing.error();
    const std::filesystem::path target = isPacked ? (*packing)->path() / "model.tan" : std::filesystem::path(output);
    const std::atomic<bool> keep = arguments.has("keep");
    const double builtEnd = isPacked ? 0.4 : 1;
    const auto buildBy = [&](const WayToBuild& by) {
        return buildModel(invocation.host, *dataset, by.builder.id, by.values, target,
                          invocation.progress.part(0.05, builtEnd),
                          {.live = nullptr,
                           .keepWhenCancelled = keep ? &keep : nullptr,
                           .resume = arguments.has("resume"),
                           .imported = toKeep(*imported, arguments)});
    };
    auto build = buildBy(*way);
    std::vector<Message> detour;
    if (auto other = wayAfter(build, *way, *dataset, arguments, invocation.host)) {
        detour = {build.error().message};
        way = *std::move(other);
        build = buildBy(*way);
    }
    if (!build) {
        if (isPacked && arguments.has("resume"))
            (*packing)->keep(); // with what the build left in it
        return arguments.has("resume") ? withWayOn(build.error(), output + (isPacked ? ".packing" : ".work"))
                                       : build.error();
    }
    Outcome outcome = outcomeOf(*build, output, Making::Built, isPacked);
    if (isPacked)
        if (const Status packed = pack(target, output, invocation.progress.part(builtEnd, 1), outcome); !packed)
            return packed.error();
    tellThreads(arguments, *threads, way->builder, *dataset, way->values, outcome);
    addRemarks(*dataset, outcome);
    addRemarks(detour, outcome);
    if (logarithmic)
        outcome.text += logarithmText(dataset->source.valueName, dataset->values.range());
    return outcome;
}

} // namespace tetra
