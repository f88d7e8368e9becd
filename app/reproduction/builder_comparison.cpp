// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/builder_comparison.h"

#include "core/base/memory.h"
#include "core/base/system_error.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/model_building.h"

#include <tan/query.h>
#include <tan/verify.h>

#include <algorithm>
#include <optional>

namespace tetra {

namespace {

ComparedDataset entry(std::string name, std::filesystem::path file, ParameterValues readerValues = {})
{
    ComparedDataset dataset;
    dataset.name = std::move(name);
    dataset.file = std::move(file);
    dataset.readerValues = std::move(readerValues);
    return dataset;
}

/// One of the ways to build that are compared, with its part of the time.
struct Way {
    std::string name;
    std::string builder;
    ParameterValues values;
    double share;
};

std::vector<Way> comparedWays(DomainClass domain)
{
    ParameterValues refined, decimated; // both as a whole, and grids with the error in the grid, as in the paper
    if (isOnLattice(domain))
        refined["block"] = std::string("none");
    if (domain == DomainClass::Curvilinear) {
        refined["error-in"] = std::string("grid");
        decimated["space"] = std::string("computational");
    }
    ParameterValues asInPaper = decimated;
    asInPaper["order"] = std::string("paper");
    return {{"refinement", "refinement", refined, 0.1},
            {"decimation", "decimation", decimated, 0.3},
            {"decimation-paper", "decimation", asInPaper, 0.5}};
}

std::vector<ComparedDataset> comparedDatasets()
{
    return {entry("BuckyBall 32", "buckyball/bucky_32x32x32_uint8.nhdr"),
            entry("SOD 32", "sod/sod_sub_32x32x32_uint8.nhdr"),
            entry("neghip 64", "regular/neghip_64x64x64_uint8.nhdr"),
            entry("hydrogen 64", "regular/hydrogen_64x64x64_float.nrrd"),
            entry("BluntFin", "bluntfin/bluntfinxyz.bin", {{"array", std::string("density")}}),
            entry("Post", "post/postxyz.bin", {{"array", std::string("pressure")}}),
            entry("SPX", "irregular/spx.vtu"),
            entry("bracket", "irregular/bracket_57k.vtu"),
            entry("disk_out_ref", "irregular/disk_out_ref_tet.vtu")};
}

/// Nothing if it cannot be had here; `skipped` says why then.
Result<std::optional<Dataset>> open(PluginHost& host, ComparedDataset& entry, const std::filesystem::path& data,
                                    const Progress& progress)
{
    std::error_code problem;
    const std::filesystem::path path = data / entry.file;
    if (!std::filesystem::exists(path, problem)) {
        entry.skipped = "There is no '" + entry.file.string() + "' in the folder of data.";
        return std::optional<Dataset>();
    }
    if (const auto reader = chooseReader(host, path); !reader) {
        entry.skipped = "No reader here reads '" + entry.file.string() + "': " + reader.error().text();
        return std::optional<Dataset>();
    }
    auto dataset = openDataset(host, path, {.values = entry.readerValues}, progress);
    if (!dataset && dataset.error().kind == ErrorKind::Cancelled)
        return dataset.error();
    if (!dataset) {
        entry.skipped = dataset.error().text();
        return std::optional<Dataset>();
    }
    return std::optional(*std::move(dataset));
}

std::string modelName(const ComparedDataset& dataset, const std::string& builder)
{
    std::string name = dataset.name + "-" + builder + ".tan";
    std::ranges::replace(name, ' ', '-');
    return name;
}

/// In %, of the best mesh with no more sites.
double accuracyWith(const Model& model, std::uint64_t sites)
{
    const double extent = model.description().range.extent();
    const float key = sites < model.siteCount() ? model.runningKeys()[sites] : model.finalKey();
    return extent > 0 ? 100 * static_cast<double>(key) / extent : 0;
}

Result<ComparedBuild> build(PluginHost& host, const Dataset& dataset, const Way& way, const std::filesystem::path& path,
                            const Progress& progress)
{
    ComparedBuild result;
    result.builder = way.name;
    if (const auto chosen = chooseBuilder(host, dataset, way.builder); !chosen) {
        result.refusal = chosen.error().text();
        return result;
    }
    const bool forgot = forgetPeakResidentBytes();
    const std::uint64_t before = residentBytes();
    const auto built = buildModel(host, dataset, way.builder, way.values, path, progress);
    if (!built)
        return built.error();
    const auto model = Model::open(path);
    if (!model)
        return model.error();
    result.model = *model;
    if (const Status right = (*model)->checkPrefix((*model)->siteCount(), Model::Batches, progress); !right)
        return right.error();
    result.seconds = built->seconds;
    result.bytes = forgot && built->peakBytes > before ? built->peakBytes - before : 0;
    result.inverted = built->report.inverted;
    result.degenerate = built->report.degenerate;
    for (const double percent : comparedAccuracies) {
        const MeshSize size = meshSizeAt(**model, {.error = percent, .warping = percent});
        result.sizes.push_back({size.sites, size.tetrahedra});
    }
    return result;
}

/// With as many sites as the first build has at 1 %, proved by the way.
Status measure(ComparedBuild& built, const Dataset& dataset, const Progress& progress)
{
    constexpr std::size_t onePercent = 3;
    static_assert(comparedAccuracies[onePercent] == 1);
    const double percent = built.accuracies[onePercent] * (1 + 1e-12); // percentages round
    const auto verdict = verify(*built.model, dataset, {{percent, percent}}, progress);
    if (!verdict)
        return verdict.error();
    const LevelReport& level = verdict->levels.front();
    if (!verdict->ok())
        return Error{ErrorKind::BadInput, "The model of '" + dataset.source.name + "' by " + built.builder +
                                              " is not what it claims: " +
                                              (verdict->failures.empty() ? level.failures : verdict->failures).front()};
    built.error = level.measured.error;
    built.measuredSites = level.sites;
    return {};
}

Status compare(PluginHost& host, ComparedDataset& entry, const std::filesystem::path& data,
               const std::filesystem::path& models, const Progress& progress)
{
    const auto dataset = open(host, entry, data, progress.part(0, 0.1));
    if (!dataset)
        return dataset.error();
    if (!dataset->has_value())
        return {};
    entry.domain = (*dataset)->domain;
    entry.points = (*dataset)->pointCount();
    double done = 0.1;
    for (const Way& way : comparedWays(entry.domain)) {
        auto built =
            build(host, **dataset, way, models / modelName(entry, way.name), progress.part(done, done + way.share));
        if (!built)
            return built.error();
        entry.builds.push_back(*std::move(built));
        done += way.share;
    }
    const auto first = std::ranges::find_if(entry.builds, [](const ComparedBuild& built) { return !!built.model; });
    for (ComparedBuild& built : entry.builds) {
        if (!built.model)
            continue;
        for (std::size_t level = 0; level < comparedAccuracies.size(); ++level)
            built.accuracies.push_back(accuracyWith(*built.model, first->sizes[level].sites));
        if (const Status measured = measure(built, **dataset, progress.part(done, done)); !measured)
            return measured;
    }
    return {};
}

} // namespace

Result<std::vector<ComparedDataset>> compareBuilders(PluginHost& host, const std::filesystem::path& data,
                                                     const std::filesystem::path& folder, const Progress& progress)
{
    const std::filesystem::path models = folder / "models";
    std::error_code problem;
    std::filesystem::create_directories(models, problem);
    if (problem)
        return Error{ErrorKind::CannotWrite, "Cannot make the folder '" + models.string() +
                                                 "': " + systemErrorText(problem.value()).text() +
                                                 ". Choose another place with -o."};
    std::vector<ComparedDataset> datasets = comparedDatasets();
    for (std::size_t number = 0; number < datasets.size(); ++number) {
        if (progress.cancelled())
            return cancelledError("The comparison");
        const auto share = [&](std::size_t done) {
            return static_cast<double>(done) / static_cast<double>(datasets.size());
        };
        const Status compared =
            compare(host, datasets[number], data, models, progress.part(share(number), share(number + 1)));
        if (!compared)
            return compared.error();
    }
    return datasets;
}

} // namespace tetra
