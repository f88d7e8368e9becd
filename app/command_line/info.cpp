// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/datasets.h"
#include "app/command_line/error_statistics.h"
#include "app/command_line/model_input.h"
#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/subcommands.h"
#include "app/command_line/table.h"
#include "core/base/file_writer.h"
#include "core/base/text.h"
#include "core/data/value_scale.h"
#include "core/history/blocks/run_files.h"
#include "core/history/error_meaning.h"
#include "core/history/query_words.h"
#include "core/history/value_statistics.h"
#include "core/verify/curvilinear_cells.h"
#include "plugins/host/build_estimate.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/input_file.h"
#include "plugins/host/output_check.h"
#include "plugins/host/parts/parts_plan.h"

#include <tan/model.h>
#include <tan/query.h>
#include <tan/verify.h>

#include <algorithm>
#include <array>
#include <optional>
#include <thread>

namespace tetra {
namespace {

/// "array": what the values are called, where that is known.
void addArrayName(const std::string& name, JsonObject& figures)
{
    if (!name.empty())
        figures["array"] = name;
}

JsonObject provenanceFigures(const ModelDescription& description)
{
    JsonObject parameters;
    for (const auto& [id, value] : description.parameters)
        parameters[id] = value;
    JsonObject figures{
        {"builder", description.builder}, {"parameters", parameters}, {"source", description.sourceName}};
    addArrayName(description.valueName, figures);
    if (holdsLogarithms(description.parameters))
        figures["scale"] = "log10";
    return figures;
}

std::string provenanceText(const ModelDescription& description)
{
    std::string text = "built by " + visibleText(description.builder) + " from " + visibleText(description.sourceName);
    for (const auto& [id, value] : description.parameters)
        if (!value.empty() && !id.starts_with(importPrefix) && !id.starts_with(statisticsPrefix)) // told elsewhere
            text.append(", ").append(visibleText(id)).append(" ").append(visibleText(value));
    return text + "\n";
}

/// Of a density map, whose isovalues are told by them.
void addStatistics(const std::optional<ValueStatistics>& found, Outcome& outcome)
{
    if (!found)
        return;
    outcome.figures["mean"] = found->mean;
    outcome.figures["standard_deviation"] = found->deviation;
    outcome.text += "mean " + rounded(found->mean) + ", standard deviation " + rounded(found->deviation) +
                    ", both of all samples\n";
}

/// What the file of the dataset offered, as the model keeps it.
void addSource(const ModelDescription& description, Outcome& outcome)
{
    for (const auto& [name, figure] : provenanceFigures(description))
        outcome.figures[name] = figure;
    outcome.text += provenanceText(description);
    addStatistics(keptStatistics(description.parameters), outcome);
    addProvenance(description.taken, description.leftOut, outcome);
}

/// The table of the levels, as rows for people and as a list for programs.
struct LevelTable {
    std::vector<std::vector<std::string>> rows;
    JsonArray list;
    bool anyInverted = false;
};

/// The head of the column of what was asked for, which is what the model guarantees.
std::string errorHead(const ModelDescription& description)
{
    return std::string(textFor(errorNames, errorMeaning(description))) + " %";
}

Result<LevelTable> levelTable(const Model& model, const std::vector<Accuracy>& levels)
{
    const bool warps = model.description().warpingWeight > 0;
    const bool logarithms = holdsLogarithms(model.description().parameters);
    std::vector<std::uint32_t> sites;
    for (const Accuracy& level : levels)
        sites.push_back(meshSizeAt(model, level).sites);
    const auto counted = countInverted(model, sites);
    if (!counted)
        return counted.error();
    const std::vector<std::uint64_t>& inverted = *counted;
    LevelTable result;
    result.anyInverted = std::ranges::any_of(inverted, [](std::uint64_t count) { return count > 0; });
    result.rows = {{errorHead(model.description()), "sites", "tetrahedra", "reached %"}};
    if (warps) {
        result.rows[0].insert(result.rows[0].begin() + 1, "warping %");
        result.rows[0].emplace_back("warping reached %");
    }
    if (logarithms)
        result.rows[0].emplace_back("factor");
    if (result.anyInverted)
        result.rows[0].emplace_back("inverted");
    for (std::size_t number = 0; number < levels.size(); ++number) {
        const Accuracy& level = levels[number];
        const MeshSize size = meshSizeOf(model, sites[number]);
        JsonObject figures{{"error", level.error},  {"warping", warps ? level.warping : 0},
                           {"sites", size.sites},   {"tetrahedra", size.tetrahedra},
                           {"reached", size.error}, {"reached_warping", size.warping}};
        if (model.description().domain == DomainClass::Curvilinear)
            figures["inverted"] = inverted[number];
        const double factor = factorOf(size.error, model.description().range);
        if (logarithms)
            figures["reached_factor"] = factor;
        result.list.push_back(figures);
        std::vector<std::string> row = {warps ? limitText(level.error) : rounded(level.error),
                                        std::to_string(size.sites), std::to_string(size.tetrahedra),
                                        rounded(size.error)};
        if (warps) {
            row.insert(row.begin() + 1, limitText(level.warping));
            row.push_back(rounded(size.warping));
        }
        if (logarithms)
            row.push_back(factorText(factor));
        if (result.anyInverted)
            row.push_back(std::to_string(inverted[number]));
        result.rows.push_back(std::move(row));
    }
    return result;
}

Status writeLevels(const Model& model, const std::vector<Accuracy>& levels, const std::filesystem::path& output)
{
    const auto text = levelsAsText(output, model, levels);
    if (!text)
        return text.error();
    if (const Status intact = model.checkIntact(); !intact)
        return intact;
    return writeWholeFile(output, std::as_bytes(std::span(*text)));
}

/// --against: what the model's levels are off the dataset on the whole; as 'tan verify' finds it, and with its answer.
Status addMeasured(const Invocation& invocation, const Model& model, const std::vector<Accuracy>& levels,
                   Outcome& outcome)
{
    const auto against = invocation.arguments.value("against");
    if (!against)
        return {};
    const auto options = importOptions(invocation, *against, &model.description());
    if (!options)
        return options.error();
    const auto original = openDataset(invocation.host, *against, *options, invocation.progress.part(0, 0.05));
    if (!original)
        return original.error();
    const auto verdict = verify(model, *original, levels, invocation.progress.part(0.05, 1));
    if (!verdict)
        return verdict.error();
    const DomainClass domain = model.description().domain;
    std::vector<NamedStatistics> measured;
    for (std::size_t number = 0; number < levels.size(); ++number) {
        JsonObject& figures = *(*outcome.figures["levels"].array())[number].object();
        addStatistics(figures, verdict->levels[number].measured, domain);
        measured.push_back({rounded(levels[number].error) + " %", verdict->levels[number].measured});
    }
    outcome.text += "\n" + statisticsText(measured, domain);
    outcome.isYes = verdict->ok();
    if (!verdict->ok())
        outcome.text += "\nThe model is NOT what it claims to be of this dataset: 'tan verify' says why.\n";
    return {};
}

Result<Outcome> describeModel(const Invocation& invocation, const std::string& path,
                              const std::vector<Accuracy>& levels, const std::optional<std::string>& output)
{
    const auto opened = openWholeInput(invocation, path, invocation.progress);
    if (!opened)
        return opened.error();
    const Model& model = *opened->model;
    if (const Status warps = checkWarpingOption(invocation.arguments, model); !warps)
        return warps.error();
    const ModelDescription& description = model.description();
    const Result<LevelTable> found = levelTable(model, levels);
    const DatasetSummary summary = summaryOf(model);
    if (const Status right = model.confirm(invocation.progress); !right)
        return right.error();
    if (!found)
        return found.error();
    if (output) {
        if (const Status safe = checkOutput(*output, std::array<std::filesystem::path, 1>{path}); !safe)
            return safe.error();
        if (const Status written = writeLevels(model, levels, *output); !written)
            return written.error();
    }

    Outcome outcome;
    outcome.figures = datasetFigures(summary);
    outcome.text = shownInput(path) + ": model of a " + datasetText(summary) + "\n";
    addSource(description, outcome);
    outcome.figures["sites"] = model.siteCount();
    outcome.figures["tetrahedra"] = model.tetrahedronCount();
    outcome.figures["bytes"] = model.fileSize();
    outcome.figures["levels"] = found->list;
    outcome.figures["error_kind"] = wordOf(errorKindWords, errorMeaning(description));
    outcome.text += std::to_string(model.siteCount()) + " sites, " + std::to_string(model.tetrahedronCount()) +
                    " tetrahedra in the history, " + byteText(model.fileSize()) + "\n\n" + table(found->rows) +
                    guaranteeText(description, invocation.arguments.has("against")) + logarithmText(description);
    if (found->anyInverted)
        outcome.text += "\nTetrahedra are inverted where the data's own cells are folded or bent too far.\n";
    if (const Status listed = addFaultyCells(model, outcome); !listed)
        return listed.error();
    if (const Status measured = addMeasured(invocation, model, levels, outcome); !measured)
        return measured.error();
    return outcome;
}

/// Of a model that is packed or on a server, as far as the front of its file tells: nothing is unpacked or fetched.
Result<Outcome> describeFront(const Invocation& invocation, const std::string& path, const std::vector<Accuracy>& asked)
{
    const auto token = tokenOption(invocation.arguments, path);
    if (!token)
        return token.error();
    const auto facts = modelFacts(path, invocation.progress, *token);
    if (!facts)
        return facts.error();
    const ModelDescription& description = facts->description;
    if (const Status fits = checkWarpingOption(invocation.arguments, description, shownInput(path)); !fits)
        return fits.error();
    const bool warps = description.warpingWeight > 0;
    const bool logarithms = holdsLogarithms(description.parameters);
    const bool isPacked = facts->form == ModelForm::Packed;
    const DatasetSummary summary = summaryOf(description);
    JsonArray list;
    std::vector<std::vector<std::string>> rows = {{errorHead(description), "sites", "read", "reached %"}};
    if (warps) {
        rows[0].insert(rows[0].begin() + 1, "warping %");
        rows[0].emplace_back("warping reached %");
    }
    if (logarithms)
        rows[0].emplace_back("factor");
    for (const Accuracy& level : asked) {
        const auto keeps = [&](const LevelInFile& one) {
            return one.error <= level.error && one.warping <= level.warping;
        };
        const auto found = std::ranges::find_if(facts->levels, keeps);
        const LevelInFile& reached = found != facts->levels.end() ? *found : facts->levels.back();
        JsonObject figures{{"error", level.error},     {"warping", warps ? level.warping : 0},
                           {"sites", reached.sites},   {"bytes", reached.bytes},
                           {"reached", reached.error}, {"reached_warping", reached.warping}};
        const double factor = factorOf(reached.error, description.range);
        if (logarithms)
            figures["reached_factor"] = factor;
        list.push_back(figures);
        std::vector<std::string> row = {warps ? limitText(level.error) : rounded(level.error),
                                        std::to_string(reached.sites), byteText(reached.bytes), rounded(reached.error)};
        if (warps) {
            row.insert(row.begin() + 1, limitText(level.warping));
            row.push_back(rounded(reached.warping));
        }
        if (logarithms)
            row.push_back(factorText(factor));
        rows.push_back(std::move(row));
    }
    Outcome outcome{.figures = datasetFigures(summary), .text = {}};
    outcome.text = shownInput(path) + ": " + (isPacked ? "packed " : "") + "model of a " + datasetText(summary) + "\n";
    addSource(description, outcome);
    outcome.figures["form"] = isPacked ? "packed" : "explicit";
    outcome.figures["sites"] = facts->sites;
    outcome.figures["tetrahedra"] = facts->tetrahedra;
    outcome.figures["bytes"] = facts->fileBytes;
    outcome.figures["unpacked_bytes"] = facts->unpackedBytes;
    outcome.figures["levels"] = list;
    outcome.figures["error_kind"] = wordOf(errorKindWords, errorMeaning(description));
    outcome.text += std::to_string(facts->sites) + " sites, " + std::to_string(facts->tetrahedra) +
                    " tetrahedra in the history, " + byteText(facts->fileBytes) +
                    (isPacked ? ", unpacked " + byteText(facts->unpackedBytes) : "") + "\n\n" + table(rows) +
                    guaranteeText(description, false) + logarithmText(description);
    return outcome;
}

/// Of builders that have an error, that of '--error'; each has its own default where it is not said.
Result<ParameterValues> errorAsked(const Arguments& arguments, const Builder& builder)
{
    ParameterValues values;
    const auto parameters = builder.parameters();
    const auto error = std::ranges::find(parameters, "error", &Parameter::id);
    if (!arguments.has("error") || error == parameters.end())
        return values;
    const auto percent = numberOption(arguments, "error", 0, 0, 100);
    if (!percent)
        return percent.error();
    values["error"] = *percent;
    return values;
}

/// What a model of it takes, by whom.
Status addEstimates(const Invocation& invocation, const BuildSize& size, const Dataset* dataset, Outcome& outcome)
{
    const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
    JsonArray list;
    for (const auto& builder : invocation.host.builders()) {
        if (dataset != nullptr && !(builder.plugin->accepts(*dataset).score > 0))
            continue;
        const auto values = errorAsked(invocation.arguments, *builder.plugin);
        if (!values)
            return values.error();
        const auto estimate = builder.plugin->estimate(size, *values, threads);
        if (!estimate)
            continue;
        list.push_back(JsonObject{{"builder", builder.id},
                                  {"memory_bytes", estimate->memoryBytes},
                                  {"disk_bytes", estimate->diskBytes},
                                  {"model_bytes", estimate->modelBytes},
                                  {"seconds", estimate->seconds}});
        outcome.text += "a build by " + visibleText(builder.id) + " would take about " +
                        byteText(estimate->memoryBytes) + " of memory, " + byteText(estimate->diskBytes) +
                        " of disk and " + durationText(estimate->seconds) + "\n";
    }
    outcome.figures["estimates"] = list;
    return {};
}

/// Files up to so many bytes are read, which takes no longer than a second; larger ones if the user asks for it.
constexpr std::uint64_t readAtOnce = 64ULL << 20U;

/// What the headers of a file tell, where its samples are not read.
Status describeHeaders(const Invocation& invocation, const std::string& path, const FileContents& contents,
                       Outcome& outcome)
{
    const Lattice& lattice = contents.lattice;
    const std::uint64_t points = contents.points != 0 ? contents.points : lattice.pointCount();
    outcome.figures["kind"] = domainClassName(*contents.domain);
    outcome.figures["points"] = points;
    if (contents.type)
        outcome.figures["type"] = sampleTypeName(*contents.type);
    outcome.text = visibleText(path) + ": " + std::string(domainClassName(*contents.domain)) + ", " +
                   std::to_string(points) + " points";
    if (isOnLattice(*contents.domain)) {
        outcome.figures["size"] = JsonArray{lattice.size[0], lattice.size[1], lattice.size[2]};
        outcome.text += ", " + std::to_string(lattice.size[0]) + " x " + std::to_string(lattice.size[1]) + " x " +
                        std::to_string(lattice.size[2]);
    }
    outcome.text += contents.type ? " (" + std::string(sampleTypeName(*contents.type)) + ")\n" : "\n";
    outcome.text += "The values were not read: '--ranges' does, and tells their range.\n";
    addContents(contents, outcome);
    addProvenance(contents.taken, contents.leftOut, outcome);
    return addEstimates(invocation,
                        {.domain = *contents.domain,
                         .points = points,
                         .tetrahedra = contents.cells,
                         .type = contents.type.value_or(SampleType::Float32)},
                        nullptr, outcome);
}

Result<Outcome> describeDataset(const Invocation& invocation, const std::string& path)
{
    const auto options = importOptions(invocation, path);
    if (!options)
        return options.error();
    // A file that is missing, or no dataset either, was told before.
    for (const char* option : {"lod", "warping", "against"})
        if (invocation.arguments.has(option))
            return Error{ErrorKind::WrongUsage, "'--" + std::string(option) + "' is of the levels of a model, and '" +
                                                    path + "' is not one. Build a model of it first."};
    std::error_code problem;
    const auto bytes = std::filesystem::file_size(path, problem);
    const auto contents = probeDataset(invocation.host, path, *options, invocation.progress.part(0, 0.2));
    const bool isKnown = contents && contents->domain && (contents->points > 0 || isOnLattice(*contents->domain));
    if (!problem && bytes > readAtOnce && isKnown && options->part.isWhole() && !options->scale.logarithmic &&
        !invocation.arguments.has("ranges")) {
        Outcome outcome;
        if (const Status described = describeHeaders(invocation, path, *contents, outcome); !described)
            return described.error();
        outcome.figures["bytes"] = bytes;
        return outcome;
    }
    const auto dataset = openDataset(invocation.host, path, *options, invocation.progress.part(0.2, 1));
    if (!dataset)
        return dataset.error();
    const DatasetSummary summary = summaryOf(*dataset);
    Outcome outcome{.figures = datasetFigures(summary),
                    .text = visibleText(path) + ": " + visibleText(dataset->source.name) + ", " + datasetText(summary) +
                            "\n"};
    outcome.figures["source"] = dataset->source.name;
    addArrayName(dataset->source.valueName, outcome.figures);
    outcome.figures["bytes"] = problem ? 0 : bytes;
    if (isDensityMap(dataset->source.name))
        addStatistics(statisticsOf(dataset->values), outcome);
    addContents(contents ? *contents : FileContents(), outcome);
    if (const Status estimated = addEstimates(invocation, buildSizeOf(*dataset), &*dataset, outcome); !estimated)
        return estimated.error();
    addRemarks(*dataset, outcome);
    if (options->scale.logarithmic) {
        outcome.figures["scale"] = "log10";
        outcome.text += logarithmText(dataset->source.valueName, dataset->values.range());
    }
    return outcome;
}

/// Of the folder of a shared build: what is finished.
Result<Outcome> describeParts(const std::string& folder)
{
    const auto plan = readPlan(folder);
    if (!plan)
        return plan.error();
    JsonArray finished;
    std::string names;
    for (const auto& [number, count] : finishedParts(folder)) {
        finished.push_back(JsonObject{{"part", number}, {"parts", count}});
        names += (names.empty() ? "" : ", ") + std::to_string(number) + "/" + std::to_string(count);
    }
    Outcome outcome;
    outcome.text = visibleText(folder) + ": the parts of a shared build of '" + visibleText(plan->input.string()) +
                   "' by " + visibleText(plan->builder) + ", " + std::to_string(plan->blocks) + " blocks\n" +
                   (names.empty() ? "No part is finished yet.\n"
                                  : "finished (" + std::to_string(finished.size()) + "): " + names + "\n");
    outcome.figures = {{"kind", "shared build"},
                       {"input", plan->input.string()},
                       {"builder", plan->builder},
                       {"blocks", plan->blocks},
                       {"finished", std::move(finished)}};
    return outcome;
}

} // namespace

Syntax infoSyntax(PluginHost& host)
{
    std::string readable;
    for (const std::string& filter : readableFiles(host))
        readable += (readable.empty() ? "" : ", ") + filter;
    Syntax syntax{
        .purpose = "show what a model or a dataset holds",
        .explanation =
            "For a model: its domain, how it was made, and the size of the mesh at each level of detail. The sizes are "
            "looked up, not counted, so this is quick for models of any size; for curvilinear grids the inverted "
            "tetrahedra are counted, at some ten million a second. For a packed model or one on a server: the sizes of "
            "a few levels, and how much of the file is read for each; nothing is unpacked or fetched. For a dataset: "
            "its size, its type, its range of values, what there is to choose from, what is taken from it, what it "
            "states that is not used, and what each builder would need for a model of it. For the folder of a shared "
            "build: which parts are finished.\n\nDatasets that can be "
            "read, also compressed with gzip (*.gz): " +
            readable + ".",
        .positionals = {{"FILE", "A model, packed or not, or its address on a server (http:// or https://); or a "
                                 "dataset that one of the readers supports."}},
        .options = {levelsOption(),
                    warpingOption(),
                    {.name = "against",
                     .placeholder = "IN",
                     .explanation = "For a model: the dataset that it was built from. Also reports the overall error "
                                    "and warping at each level, with the error in space for curvilinear grids and the "
                                    "error at the nearest place for irregular data; takes as long as 'tan verify'."},
                    {.name = "ranges",
                     .placeholder = "",
                     .explanation = "For a dataset of more than 64 MB: also reads its values, and reports their range. "
                                    "Without it only the headers of such a file are read, which is immediate."},
                    {.name = "error",
                     .placeholder = "P",
                     .explanation = "For a dataset: the error, in percent of the value range, down to which a model "
                                    "would be built, to estimate what that takes.",
                     .byDefault = "that of each builder"},
                    outputOption("FILE.csv|.json", "For a model: also write the levels to this file.", false),
                    tokenFileOption()},
        .examples = {
            {"tan info engine.tan --lod 1,.5,.1", "The meshes at three accuracies."},
            {"tan info engine.tan -o levels.csv", "The meshes at the usual accuracies, for a spreadsheet."},
            {"tan info engine.tan --lod 1 --against engine.nrrd", "Also reports how far a mesh is off overall."},
            {"tan info engine.nrrd --json", "A dataset, for a program."}}};
    addImportOptions(syntax, host);
    syntax.exitCodes = {0, 1, 2, 3, 4, 130}; // 1: of '--against'
    return syntax;
}

Result<Outcome> runInfo(const Invocation& invocation)
{
    const std::string& path = invocation.arguments.positionals[0];
    const auto levels = levelsOf(invocation.arguments);
    if (!levels)
        return levels.error();
    const auto output = invocation.arguments.value("output");
    if (!isAddress(path) && !isModelFile(path)) {
        if (const auto token = tokenOption(invocation.arguments, path); !token)
            return token.error();
        if (output)
            return Error{ErrorKind::WrongUsage, "'--output' writes the levels of a model, and '" + path +
                                                    "' is not one. Build a model of it first."};
        return hasPlan(path) ? describeParts(path) : describeDataset(invocation, path);
    }
    const bool against = invocation.arguments.has("against");
    for (const char* option : {"ranges", "error"})
        if (invocation.arguments.has(option))
            return Error{ErrorKind::WrongUsage,
                         "The model '" + path + "' has no option '--" + option + "': it is for datasets."};
    for (const char* option : {"reader", "region", "stride", "scale"})
        if (!against && invocation.arguments.has(option))
            return Error{ErrorKind::WrongUsage,
                         "The model '" + path + "' has no option '--" + option + "': it is for datasets."};
    if (const Status known = against
                                 ? Status()
                                 : checkPluginOptions(invocation.arguments, allParameters(invocation.host.readers()),
                                                      {}, "model '" + path + "'");
        !known)
        return known.error();
    const bool needsMeshes = against || output.has_value();
    return isAtHand(path) || needsMeshes ? describeModel(invocation, path, *levels, output)
                                         : describeFront(invocation, path, *levels);
}

} // namespace tetra
