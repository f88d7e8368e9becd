// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/building/pack.h"

#include "app/command_line/model_input.h"
#include "app/command_line/option_values.h"
#include "app/command_line/subcommands.h"
#include "app/command_line/table.h"
#include "core/base/text.h"
#include "core/build/model_build.h"
#include "plugins/host/output_check.h"

#include <algorithm>
#include <array>

namespace tetra {

void addPacking(const PackReport& report, std::uint64_t unpackedBytes, Outcome& outcome)
{
    const bool replayed = report.method == PackMethod::Replayed;
    outcome.figures["packed"] = JsonObject{{"method", replayed ? "replayed" : "by-parts"},
                                           {"bytes", report.fileBytes},
                                           {"unpacked_bytes", unpackedBytes},
                                           {"positions", report.positions},
                                           {"values", report.values},
                                           {"accuracy", report.accuracy},
                                           {"own_errors", report.ownErrors},
                                           {"other", report.other}};
    const double times =
        static_cast<double>(unpackedBytes) / static_cast<double>(std::max<std::uint64_t>(report.fileBytes, 1));
    outcome.text += "packed from " + byteText(unpackedBytes) + " to " + byteText(report.fileBytes) + ", " +
                    rounded(times, 3) + " times smaller, " +
                    (replayed ? "as the samples from which the history is rebuilt\n"
                              : "part by part, without what can be derived from the rest\n");
}

Syntax packSyntax(PluginHost&)
{
    return {.purpose = "pack a model, to archive it or to send it over a network",
            .explanation = "A packed model is a small fraction of the size, and unpacks to the same model byte for "
                           "byte. Every command, and the window, accepts it in place of the model: they unpack it into "
                           "a cache folder, or only its beginning where no fine mesh is needed.",
            .positionals = {{"MODEL", modelExplanation()}},
            .options = {outputOption("PACKED", "The packed model to write, conventionally *.packed.tan."),
                        tokenFileOption()},
            .examples = {{"tan pack engine.tan -o engine.packed.tan", "engine.tan can then be deleted."}}};
}

Result<Outcome> runPack(const Invocation& invocation)
{
    const std::filesystem::path input = invocation.arguments.positionals[0];
    const std::filesystem::path output = *invocation.arguments.value("output");
    if (const Status distinct = checkOutput(output, std::array{input}); !distinct)
        return distinct.error();
    if (const Status safe = checkModelOutput(output); !safe)
        return safe.error();
    const auto found = openWholeInput(invocation, input, invocation.progress.part(0, 0.05));
    if (!found)
        return found.error();
    const auto report = packModel(*found->model, output, invocation.progress.part(0.05, 1));
    if (!report)
        return report.error();
    Outcome outcome{.figures = {{"file", output.string()}, {"sites", found->model->siteCount()}},
                    .text =
                        visibleText(output.string()) + ": " + std::to_string(found->model->siteCount()) + " sites, "};
    addPacking(*report, found->model->fileSize(), outcome);
    return outcome;
}

} // namespace tetra
