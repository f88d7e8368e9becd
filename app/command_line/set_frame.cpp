// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/datasets.h"
#include "app/command_line/model_input.h"
#include "app/command_line/subcommands.h"
#include "core/base/text.h"
#include "core/build/model_build.h"
#include "plugins/api/placement_parameters.h"
#include "plugins/host/output_check.h"

#include <array>

namespace tetra {
namespace {

/// Three numbers, if the option is there, as 'tan build' takes them.
Result<std::optional<Eigen::Vector3d>> vectorOption(const Arguments& arguments, const std::string& name)
{
    if (!arguments.has(name))
        return std::optional<Eigen::Vector3d>();
    const auto numbers = parseThree<double>(name, *arguments.value(name));
    if (!numbers)
        return numbers.error();
    const Eigen::Vector3d vector((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    if (!vector.allFinite() || (name == "spacing" && vector.minCoeff() <= 0))
        return Error{ErrorKind::WrongUsage,
                     "'--" + name + "' takes three numbers" +
                         (name == "spacing" ? " greater than 0, the distances of neighbouring points" : "") +
                         " along x, y and z."};
    return std::optional(vector);
}

Result<Placement> placementOf(const Arguments& arguments)
{
    const auto spacing = vectorOption(arguments, "spacing");
    if (!spacing)
        return spacing.error();
    const auto origin = vectorOption(arguments, "origin");
    if (!origin)
        return origin.error();
    Placement placement{*spacing, *origin, std::nullopt};
    if (arguments.has("unit"))
        placement.lengthUnit = *arguments.value("unit");
    if (!placement.spacing && !placement.origin && !placement.lengthUnit)
        return Error{ErrorKind::WrongUsage, "Nothing to set. Give '--spacing', '--origin' or '--unit'."};
    return placement;
}

} // namespace

Syntax setFrameSyntax(PluginHost&)
{
    return {.purpose = "set the position of a model's lattice",
            .explanation =
                "Data without a spacing, an origin or a unit are built as if points were 1 apart. This writes the "
                "model with the correct ones, without building it again: its meshes are the same, at the correct "
                "places. If the ratios of the spacings differ from those it was built with, a rebuilt model has "
                "somewhat fewer points for an error; 'tan build' on data that state their spacing makes one.",
            .positionals = {{"MODEL", modelExplanation()}},
            .options = {{.name = "spacing",
                         .placeholder = "X,Y,Z",
                         .explanation = "The distance between neighbouring points along each axis of the lattice."},
                        {.name = "origin", .placeholder = "X,Y,Z", .explanation = "The position of its first point."},
                        {.name = "unit",
                         .placeholder = "TEXT",
                         .explanation = "The unit of length, such as mm: it is recorded, and nothing is converted."},
                        outputOption("FILE", "The model to write, conventionally *.tan."),
                        tokenFileOption()},
            .examples = {{"tan set-frame scan.tan --spacing 0.7,0.7,1.25 --unit mm -o placed.tan",
                          "For a stack of images without a spacing."}}};
}

Result<Outcome> runSetFrame(const Invocation& invocation)
{
    const std::filesystem::path input = invocation.arguments.positionals[0];
    const std::filesystem::path output = *invocation.arguments.value("output");
    const auto placement = placementOf(invocation.arguments);
    if (!placement)
        return placement.error();
    if (const Status distinct = checkOutput(output, std::array{input}); !distinct)
        return distinct.error();
    if (const Status safe = checkModelOutput(output); !safe)
        return safe.error();
    const auto found = openWholeInput(invocation, input, invocation.progress.part(0, 0.5));
    if (!found)
        return found.error();
    if (const Status written = writePlaced(*found->model, *placement, output, invocation.progress.part(0.5, 1));
        !written)
        return written.error();
    const auto model = Model::open(output);
    if (!model)
        return model.error();
    const DatasetSummary summary = summaryOf((*model)->description());
    Outcome outcome{.figures = datasetFigures(summary), .text = {}};
    outcome.figures["model"] = output.string();
    outcome.figures["bytes"] = (*model)->fileSize();
    outcome.text = visibleText(output.string()) + ": " + datasetText(summary) + "\n";
    return outcome;
}

} // namespace tetra
