// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/datasets.h"
#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/subcommands.h"
#include "app/command_line/table.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/model_building.h"
#include "plugins/host/output_check.h"

#include <QFile>

#include <tbb/global_control.h>

#include <array>
#include <atomic>

namespace tetra {
namespace {

/// Before anything long is done.
Status checkOutputs(const std::filesystem::path& input, const std::filesystem::path& output)
{
    if (const Status distinct = checkOutput(output, std::array{input}); !distinct)
        return distinct;
    return checkModelOutput(output);
}

Outcome describe(const ModelBuild& build, const std::string& output)
{
    const BuildReport& report = build.report;
    Outcome outcome;
    outcome.figures = {{"model", QFile::decodeName(output.c_str())},
                       {"builder", QString::fromStdString(build.builder)},
                       {"sites", static_cast<qint64>(report.sites)},
                       {"tetrahedra", static_cast<qint64>(report.tetrahedra)},
                       {"seconds", build.seconds},
                       {"peak_bytes", static_cast<qint64>(build.peakBytes)},
                       {"inverted", static_cast<qint64>(report.inverted)},
                       {"degenerate", static_cast<qint64>(report.degenerate)},
                       {"bytes", static_cast<qint64>(build.fileBytes)},
                       {"stopped_early", build.stoppedEarly}};
    outcome.text = output + ": " + std::to_string(report.sites) + " sites, " + std::to_string(report.tetrahedra) +
                   " tetrahedra in the history, " + byteText(build.fileBytes) + "\nbuilt by " + build.builder + " in " +
                   rounded(build.seconds, 3) + " s, using at most " + byteText(build.peakBytes) + " of memory\n";
    if (build.stoppedEarly)
        outcome.text += "Stopped early: 'tan info' tells what accuracy it has.\n";
    if (report.inverted > 0)
        outcome.text += "inverted tetrahedra in the finest mesh: " + std::to_string(report.inverted) +
                        ", where the data's own cells are folded or bent too far\n";
    if (report.degenerate > 0)
        outcome.text += "tetrahedra without volume in the finest mesh: " + std::to_string(report.degenerate) + "\n";
    return outcome;
}

/// A reader that nobody chose and that has nothing to be told is no choice.
ImportOptions toKeep(ImportOptions imported, const Arguments& arguments)
{
    if (!arguments.has("reader") && imported.values.empty())
        imported.reader.reset();
    return imported;
}

} // namespace

Syntax buildSyntax(PluginHost& host)
{
    Syntax syntax{
        .purpose = "build a multiresolution model from a dataset",
        .explanation =
            "The model holds the whole history of the mesh, coarse to fine, so that any accuracy can be had "
            "from it later without building again. The file appears when it is complete; when the build is "
            "cancelled or fails, nothing is left (but see --keep and --resume) and an older model of that name stays "
            "as it was. Until then all files of the build lie in the folder MODEL.work.",
        .positionals = {{"IN", "The dataset: " + std::string("a file that one of the readers knows.")}},
        .options = {outputOption("MODEL", "The model to write, by habit with the ending .tan."),
                    {.name = "builder",
                     .placeholder = idChoices(host.builders()),
                     .explanation = "Who builds.",
                     .byDefault = "the one that suits the dataset best"},
                    {.name = "keep",
                     .placeholder = "",
                     .explanation =
                         "When the build is interrupted, keep what is finished as a model of less accuracy."},
                    threadsOption(),
                    {.name = "resume",
                     .placeholder = "",
                     .explanation = "Go on with what an interrupted build of the same model left behind; the result is "
                                    "the same. Keeps it, too, if this one is cancelled."}},
        .examples = {{"tan build engine.nrrd -o engine.tan", "Everything, down to an error of 0."},
                     {"tan build engine.nrrd --error 0.5 -o engine.tan", "A smaller model, exact to 0.5 %."},
                     {"tan build engine.nrrd --region 0,0,32,255,255,95 --stride 2,2,1 -o middle.tan",
                      "A part of the data, more coarsely."}}};
    addPluginOptions(syntax, allParameters(host.builders()));
    addImportOptions(syntax, host);
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
    if (const Status safe = checkOutputs(input, output); !safe)
        return safe.error();

    auto imported = importOptions(invocation, input);
    if (!imported)
        return imported.error();
    const auto dataset = openDataset(invocation.host, input, *imported, invocation.progress.part(0, 0.05));
    if (!dataset)
        return dataset.error();
    const auto builder = chooseBuilder(invocation.host, *dataset, arguments.value("builder"));
    if (!builder)
        return builder.error();
    const auto parameters = builder->plugin->parameters();
    if (const Status known = checkPluginOptions(arguments, allParameters(invocation.host.builders()), parameters,
                                                "builder '" + builder->id + "'");
        !known)
        return known.error();
    const auto values = pluginValues(arguments, parameters);
    if (!values)
        return values.error();
    const std::atomic<bool> keep = arguments.has("keep");
    const auto build =
        buildModel(invocation.host, *dataset, builder->id, *values, output, invocation.progress.part(0.05, 1),
                   {.live = nullptr,
                    .keepWhenCancelled = &keep,
                    .resume = arguments.has("resume"),
                    .imported = toKeep(*std::move(imported), arguments)});
    if (!build)
        return build.error();
    Outcome outcome = describe(*build, output);
    addRemarks(*dataset, outcome);
    return outcome;
}

} // namespace tetra
