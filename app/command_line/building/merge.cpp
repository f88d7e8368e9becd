// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/building/build_outcome.h"
#include "app/command_line/option_values.h"
#include "app/command_line/subcommands.h"
#include "plugins/host/parts/part_building.h"

#include <tbb/global_control.h>

#include <optional>
#include <string>

namespace tetra {

Syntax mergeSyntax(PluginHost& /*host*/)
{
    return {.purpose = "make the model of a build that was shared",
            .explanation = "The parts were built by 'tan build --part'; 'tan build --help' says how. If some are not "
                           "finished yet, their numbers are printed and the exit code is 5. The dataset is read again "
                           "from where it lay, and has to be the same. The folder stays as it is: remove it when you "
                           "have the model.",
            .positionals = {{"FOLDER", "The folder with the parts."}},
            .options = {outputOption("MODEL", "The model to write, conventionally *.tan."), threadsOption()},
            .examples = {{"tan merge engine.parts -o engine.tan", "After all of its parts."}},
            .exitCodes = {0, 2, 3, 4, 5, 130}};
}

Result<Outcome> runMerge(const Invocation& invocation)
{
    const Arguments& arguments = invocation.arguments;
    const auto threads = threadsOf(arguments);
    if (!threads)
        return threads.error();
    std::optional<tbb::global_control> limit;
    if (*threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(*threads));
    const std::string output = *arguments.value("output");
    const auto build = mergeParts(invocation.host, arguments.positionals[0], output, invocation.progress);
    return build ? Result(outcomeOf(*build, output, Making::Merged)) : build.error();
}

} // namespace tetra
