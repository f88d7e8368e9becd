// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/datasets.h"
#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/subcommands.h"
#include "app/command_line/table.h"
#include "core/base/text.h"
#include "plugins/host/file_saving.h"
#include "plugins/samples/samples.h"

#include <algorithm>

namespace tetra {
namespace {

constexpr std::int64_t defaultSampleSize = 64;
constexpr std::array<SampleType, 8> sampleTypes = {SampleType::UInt8,   SampleType::Int8,   SampleType::UInt16,
                                                   SampleType::Int16,   SampleType::UInt32, SampleType::Int32,
                                                   SampleType::Float32, SampleType::Float64};

std::string typeNames()
{
    std::string names;
    for (const SampleType type : sampleTypes)
        names += (names.empty() ? "" : "|") + std::string(sampleTypeName(type));
    return names;
}

Outcome listOfSamples()
{
    JsonArray list;
    std::string text;
    for (const SampleKind& kind : sampleKinds()) {
        const std::string name(kind.name);
        const std::string description(kind.description);
        list.push_back(
            JsonObject{{"name", name}, {"kind", domainClassName(kind.domain)}, {"description", description}});
        text += name + "\n    " + description + "\n";
    }
    return {.figures = {{"samples", list}}, .text = text};
}

Result<SampleRequest> requestOf(const Arguments& arguments)
{
    SampleRequest request;
    request.name = arguments.positionals[0];
    const auto size = wholeNumberOption(arguments, "size", defaultSampleSize, smallestSampleSize, largestSampleSize);
    if (!size)
        return size.error();
    request.size = static_cast<std::uint32_t>(*size);
    const auto seed = wholeNumberOption(arguments, "seed", 1, 0, std::int64_t(1) << 53);
    if (!seed)
        return seed.error();
    request.seed = static_cast<std::uint64_t>(*seed);
    const auto kind = std::ranges::find(sampleKinds(), request.name, &SampleKind::name);
    if (arguments.has("seed") && kind != sampleKinds().end() && !kind->hasChance)
        return Error{ErrorKind::WrongUsage, "'--seed' is for samples with random values, and '" +
                                                std::string(request.name) +
                                                "' has none: it is the same for each number. Leave it out."};
    if (const auto given = arguments.value("type")) {
        const auto type = std::ranges::find(sampleTypes, *given, sampleTypeName);
        if (type == sampleTypes.end())
            return Error{ErrorKind::WrongUsage,
                         "'" + *given + "' does not fit '--type': it takes " + typeNames() + "."};
        request.type = *type;
    }
    return request;
}

} // namespace

Syntax sampleSyntax(PluginHost& host)
{
    std::string names;
    for (const SampleKind& kind : sampleKinds())
        names += (names.empty() ? "" : ", ") + std::string(kind.name);
    Syntax syntax{
        .purpose = "make a dataset from a formula, to try TAn without data",
        .explanation =
            "The dataset is a cube of samples, a curvilinear grid (blunt-body, o-grid, bent-duct, stretched), "
            "scattered points or an irregular mesh (part), with values from 0 to 1, or over the whole range of an "
            "integer type. It is the same on "
            "every machine. Cubes are written as .nrrd, curvilinear grids as .xyz with a .q file beside it (PLOT3D), "
            "scattered points as .csv, irregular meshes as .vtu.",
        .positionals = {{"NAME", "Which one: " + names + ".", false}},
        .options = {outputOption("FILE", "The file to write; its ending determines the format.", false),
                    {.name = "size",
                     .placeholder = "N",
                     .explanation = "Samples along each axis, " + std::to_string(smallestSampleSize) + " to " +
                                    std::to_string(largestSampleSize) +
                                    "; for scattered points the cube root of their number, for the part eight times "
                                    "the cells between two holes, to " +
                                    std::to_string(largestScatteredSize) + ".",
                     .byDefault = std::to_string(defaultSampleSize)},
                    {.name = "type",
                     .placeholder = typeNames(),
                     .explanation = "The type of the samples.",
                     .byDefault = "the sample's own"},
                    {.name = "seed",
                     .placeholder = "N",
                     .explanation = "A different noise or different points for each number.",
                     .byDefault = "1"},
                    {.name = "list", .placeholder = "", .explanation = "Only list the samples."}},
        .examples = {{"tan sample c60 --size 64 -o c60.nrrd", "The electrons around a ball of sixty carbon atoms."},
                     {"tan sample blunt-body --size 48 -o body.xyz", "A curvilinear grid; body.q holds its values."},
                     {"tan sample scattered --size 20 -o ball.csv", "8000 random points in a ball."},
                     {"tan sample part -o part.vtu", "A plate with holes, as tetrahedra."},
                     {"tan sample --list", "What there is."}}};
    addPluginOptions(syntax, writerParameters(host, WrittenContent::Dataset));
    syntax.exitCodes = {0, 2, 4, 130}; // no file is read
    return syntax;
}

Result<Outcome> runSample(const Invocation& invocation)
{
    const Arguments& arguments = invocation.arguments;
    if (arguments.has("list"))
        return listOfSamples();
    const auto output = arguments.value("output");
    if (arguments.positionals.empty() || !output)
        return Error{
            ErrorKind::WrongUsage,
            "Both NAME and '-o FILE' are required: tan sample c60 -o c60.nrrd. 'tan sample --list' lists the samples."};
    const auto request = requestOf(arguments);
    if (!request)
        return request.error();
    const auto values = pluginValues(arguments, writerParameters(invocation.host, WrittenContent::Dataset));
    if (!values)
        return values.error();
    const auto dataset = makeSample(*request, invocation.progress.part(0, 0.7));
    if (!dataset)
        return dataset.error();
    const auto saved = saveDataset(invocation.host, *dataset, *output, *values, invocation.progress.part(0.7, 1));
    if (!saved)
        return saved.error();

    const DatasetSummary summary = summaryOf(*dataset);
    Outcome outcome{.figures = datasetFigures(summary),
                    .text = visibleText(*output) + ": " + datasetText(summary) + "\n"};
    outcome.figures["file"] = *output;
    outcome.figures["name"] = arguments.positionals[0];
    addRemarks(*saved, outcome);
    return outcome;
}

} // namespace tetra
