// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/parts/part_building.h"

#include "core/base/memory.h"
#include "core/build/blocked_build.h"
#include "core/build/model_build.h"
#include "core/history/blocks/run_files.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/output_check.h"
#include "plugins/host/parameter_text.h"
#include "plugins/host/parameter_values.h"

#include <tan/build.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <system_error>
#include <utility>

namespace tetra {
namespace {

constexpr const char* blockId = "block";
constexpr const char* usualBlock = "32";

/// The values, with the edge of a block if its choice is left to the builder, as that may depend on the machine.
ParameterValues withBlock(const std::vector<Parameter>& parameters, ParameterValues values)
{
    const auto block = std::ranges::find(parameters, blockId, &Parameter::id);
    if (block != parameters.end() && (!values.contains(blockId) || values.at(blockId) == block->defaultValue))
        values[blockId] = std::string(usualBlock);
    return values;
}

Result<ParameterValues> valuesOf(const PartsPlan& plan, const std::vector<Parameter>& parameters)
{
    ParameterValues values;
    for (const auto& [id, text] : plan.parameters) {
        const auto parameter = std::ranges::find(parameters, id, &Parameter::id);
        if (parameter == parameters.end())
            return Error{ErrorKind::BadInput,
                         Message::say("The builder '%1' has no parameter '%2', which the plan of this build sets. Use "
                                      "one version of it for all parts.",
                                      plan.builder, id)};
        auto value = parseParameter(*parameter, text);
        if (!value)
            return value.error();
        values[id] = *std::move(value);
    }
    return values;
}

/// The builder of a plan, and what the plan asks of it.
struct PlannedWay {
    Provided<Builder> builder;
    ParameterValues values;
};

Result<PlannedWay> wayOf(PluginHost& host, const PartsPlan& plan)
{
    auto builder = host.builder(plan.builder);
    if (!builder)
        return builder.error();
    auto values = valuesOf(plan, builder->plugin->parameters());
    if (!values)
        return values.error();
    return PlannedWay{*std::move(builder), *std::move(values)};
}

/// Opens the input as it was when the build was prepared.
Result<ImportOptions> importedFor(PluginHost& host, const PartsPlan& plan)
{
    ModelDescription kept;
    kept.parameters = plan.imported;
    const auto reader = chooseReader(host, plan.input, importReaderOf(kept));
    return reader ? importOf(kept, reader->plugin->parameters()) : reader.error();
}

Error changed(const PartsPlan& plan)
{
    return {ErrorKind::BadInput,
            Message::say("'%1' has changed since the build was prepared. Prepare it anew, in another folder.",
                         plan.input.string()),
            plan.input};
}

/// All of it, checked.
Result<Dataset> openedAgain(PluginHost& host, const PartsPlan& plan, const ImportOptions& imported,
                            const Progress& progress)
{
    auto dataset = openDataset(host, plan.input, imported, progress);
    if (dataset && dataset->source.hash != plan.hash)
        return changed(plan);
    return dataset;
}

Result<Dataset> datasetOfPart(PluginHost& host, const PartsPlan& plan, const Progress& progress)
{
    if (plan.samples)
        return mappedDataset(plan);
    const auto imported = importedFor(host, plan);
    return imported ? openedAgain(host, plan, *imported, progress) : imported.error();
}

/// A part hands nothing over.
class NoHistory final : public HistorySink {
public:
    Status add(const HistoryStep& /*step*/) override
    {
        return Error{ErrorKind::WrongUsage, Message::say("This builder does not build in parts.")};
    }
    Status finish(float /*finalKey*/) override { return {}; }
};

/// Whether the builder would build the dataset in parts with these values, as far as it knows them.
bool takesParts(const Builder& builder, const Dataset& dataset, const ParameterValues& values)
{
    const auto parameters = builder.parameters();
    return checkParameterValues({}, parameters, values) && checkOfUse(parameters, values, dataset) &&
           builder.abilities(dataset, values).takesParts;
}

/// The builder with this id, or without one the most suitable of those that build in parts.
Result<Provided<Builder>> builderOfParts(PluginHost& host, const Dataset& dataset, const std::optional<std::string>& id,
                                         const ParameterValues& values)
{
    Provided<Builder> best;
    double bestScore = 0;
    for (auto& builder : host.builders()) {
        const double score = !id || builder.id == *id ? builder.plugin->accepts(dataset).score : 0;
        if (score > bestScore &&
            takesParts(*builder.plugin, dataset, withBlock(builder.plugin->parameters(), values))) {
            bestScore = score;
            best = std::move(builder);
        }
    }
    if (best.plugin != nullptr)
        return best;
    if (const auto named = chooseBuilder(host, dataset, id); !named)
        return named.error();
    return Error{ErrorKind::WrongUsage,
                 Message::say("'%1' cannot be built in parts with these options: that takes a regular lattice or a "
                              "curvilinear grid, refined in blocks. Build it as a whole.",
                              dataset.source.name)};
}

} // namespace

Result<PreparedParts> prepareParts(PluginHost& host, const std::filesystem::path& input, const ImportOptions& imported,
                                   const std::optional<std::string>& builderId, const ParameterValues& given,
                                   const std::filesystem::path& folder, const Progress& progress)
{
    const auto dataset = openDataset(host, input, imported, progress);
    if (!dataset)
        return dataset.error();
    const auto builder = builderOfParts(host, *dataset, builderId, given);
    if (!builder)
        return builder.error();
    const auto parameters = builder->plugin->parameters();
    const ParameterValues values = withBlock(parameters, given);
    const auto cells =
        chooseBlocks(parseNumber<std::uint32_t>(parameterText(values.at(blockId))), dataset->lattice, usableBytes());
    if (!cells)
        return cells.error();
    PartsPlan plan{.input = std::filesystem::absolute(input),
                   .imported = importTexts(imported),
                   .builder = builder->id,
                   .parameters = usedTexts(parameters, values, *dataset),
                   .name = dataset->source.name,
                   .hash = dataset->source.hash,
                   .domain = dataset->domain,
                   .type = dataset->values.type(),
                   .lattice = dataset->lattice,
                   .range = dataset->values.range(),
                   .samples = samplesInFile(*dataset),
                   .blocks = static_cast<std::uint32_t>(blockCount(dataset->lattice, *cells))};
    if (const Status intact = dataset->checkIntact(); !intact)
        return intact.error();
    const Status written = writePlan(folder, plan);
    return written ? Result(PreparedParts{std::move(plan), *dataset}) : written.error();
}

Result<BuiltPart> buildPart(PluginHost& host, const std::filesystem::path& folder, std::uint32_t number,
                            std::uint32_t count, bool waits, const Progress& progress)
{
    constexpr double openedEnd = 0.05;
    const auto start = std::chrono::steady_clock::now();
    const auto plan = readPlan(folder);
    if (!plan)
        return plan.error();
    if (number < 1 || number > count)
        return Error{ErrorKind::WrongUsage,
                     Message::say("There is no part %1 of %2. Parts are numbered from 1.", number, count)};
    const auto way = wayOf(host, *plan);
    if (!way)
        return way.error();
    const auto whole = datasetOfPart(host, *plan, progress.part(0, openedEnd));
    if (!whole)
        return whole.error();
    const auto dataset = way->builder.plugin->taken(*whole, way->values, {});
    if (!dataset)
        return dataset.error();
    NoHistory none;
    BuildTarget target{.history = none, .workFolder = folder};
    target.part = BuildPart{.folder = folder, .number = number, .count = count, .waits = waits};
    const std::filesystem::path file = folder / partFileName({number, count});
    std::error_code missing;
    const auto before = std::filesystem::last_write_time(file, missing);
    const auto report = way->builder.plugin->build(*dataset, way->values, target, progress.part(openedEnd, 1));
    if (!report)
        return report.error();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    std::error_code gone;
    const bool wasFinished = !missing && std::filesystem::last_write_time(file, gone) == before;
    return BuiltPart{wasFinished, report->sites, report->tetrahedra, elapsed.count(), peakResidentBytes()};
}

Result<ModelBuild> mergeParts(PluginHost& host, const std::filesystem::path& folder,
                              const std::filesystem::path& output, const Progress& progress)
{
    constexpr double openedEnd = 0.1;
    const auto plan = readPlan(folder);
    if (!plan)
        return plan.error();
    // Before the whole dataset is read.
    if (const Status there = checkNoneMissing(folder); !there)
        return there.error();
    if (const Status safe = checkOutput(output, std::array{plan->input}); !safe)
        return safe.error();
    if (const Status safe = checkModelOutput(output); !safe)
        return safe.error();
    const auto way = wayOf(host, *plan);
    if (!way)
        return way.error();
    const auto imported = importedFor(host, *plan);
    if (!imported)
        return imported.error();
    const auto dataset = openedAgain(host, *plan, *imported, progress.part(0, openedEnd));
    if (!dataset)
        return dataset.error();
    return buildModel(host, *dataset, plan->builder, way->values, output, progress.part(openedEnd, 1),
                      {.partsIn = folder, .imported = *imported});
}

} // namespace tetra
