// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/reproduction.h"

#include "core/base/system_error.h"
#include "plugins/host/model_building.h"

#include <tan/query.h>
#include <tan/render.h>

#include <chrono>

namespace tetra {

namespace {

struct Job {
    int table;
    PaperModel paper;
    Experiment experiment;
};

/// What has to be built for these tables; Table 4 looks at a model of Table 1.
Result<std::vector<Job>> jobsFor(const std::filesystem::path& paper, const std::set<int>& tables)
{
    std::vector<Job> jobs;
    for (const int table : {1, 2, 3}) {
        const bool onlyForSurfaces = table == 1 && !tables.contains(1) && tables.contains(4);
        if (!tables.contains(table) && !onlyForSurfaces)
            continue;
        const auto models = readPaperModels(paper, table);
        if (!models)
            return models.error();
        for (const PaperModel& model : *models)
            if (!onlyForSurfaces || model.dataset == "BluntFin")
                for (const Experiment& experiment : experimentsFor(model))
                    jobs.push_back({table, model, experiment});
    }
    return jobs;
}

/// "table1-BluntFin-40x32x32-as-in-the-paper.tan"
std::string modelName(const Job& job)
{
    std::string name = "table" + std::to_string(job.table) + "-" + job.paper.dataset;
    for (std::size_t axis = 0; axis < 3; ++axis)
        name += (axis == 0 ? "-" : "x") + std::to_string(job.paper.size[axis]);
    if (!job.experiment.variant.empty())
        name += "-" + job.experiment.variant;
    for (char& c : name)
        c = c == ' ' ? '-' : c;
    return name + ".tan";
}

Result<ReproducedModel> build(PluginHost& host, const Job& job, const std::filesystem::path& data,
                              const std::filesystem::path& models, const Progress& progress)
{
    ReproducedModel result{.table = job.table,
                           .paper = job.paper,
                           .experiment = job.experiment,
                           .dataset = {},
                           .model = nullptr,
                           .levels = {}};
    auto dataset = openExperiment(host, job.experiment, data, progress.part(0, 0.1));
    if (!dataset)
        return dataset.error();
    if (!dataset->has_value())
        return result;
    result.dataset = **std::move(dataset);
    const std::filesystem::path path = models / modelName(job);
    const auto built =
        buildModel(host, *result.dataset, "refinement", job.experiment.builderValues, path, progress.part(0.1, 0.9));
    if (!built)
        return built.error();
    result.seconds = built->seconds;
    result.inverted = built->report.inverted;
    result.degenerate = built->report.degenerate;
    const auto model = Model::open(path);
    if (!model)
        return model.error();
    result.model = *model;
    // All that tables and figures look up in it.
    for (const Status& right : {result.model->checkPrefix(result.model->siteCount(), Model::Batches, progress),
                                result.model->check(result.model->points(), progress)})
        if (!right)
            return right.error();
    for (const PaperLevel& level : job.paper.levels) {
        const MeshSize size = meshSizeAt(*result.model, {.error = level.error, .warping = level.warping});
        result.levels.push_back({level, size.sites, size.tetrahedra});
    }
    return result;
}

/// How many triangles the surface has, and how long it takes to extract it.
struct TimedSurface {
    std::size_t triangles = 0;
    double seconds = 0;
};

Result<TimedSurface> timeSurface(const Model& model, std::uint32_t sites, double isovalue, const Progress& progress)
{
    const auto mesh = extractPrefix(model, sites, progress);
    if (!mesh)
        return mesh.error();
    const auto start = std::chrono::steady_clock::now();
    const auto surface = extractIsosurface(*mesh, vertexGradients(*mesh), isovalue, progress);
    if (!surface)
        return surface.error();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    return TimedSurface{surface->triangles.size(), elapsed.count()};
}

Result<ReproducedSurface> measure(PluginHost& host, const ReproducedModel& model, const PaperSurface& paper,
                                  const Progress& progress)
{
    const MeshSize size = meshSizeAt(*model.model, {.error = paper.error, .warping = paper.warping});
    const auto surface = timeSurface(*model.model, size.sites, paper.isovalue, progress);
    if (!surface)
        return surface.error();
    MeshQuery query;
    query.error = paper.error;
    query.warping = paper.warping;
    const auto times = measureDrawing(host, model.model, query, paper.isovalue, progress);
    if (!times)
        return times.error();
    return ReproducedSurface{.paper = paper,
                             .variant = model.experiment.variant,
                             .sites = size.sites,
                             .tetrahedra = size.tetrahedra,
                             .triangles = surface->triangles,
                             .extractionSeconds = surface->seconds,
                             .times = *times};
}

Status measureSurfaces(PluginHost& host, Reproduction& reproduction, const std::filesystem::path& paper,
                       const Progress& progress)
{
    const auto rows = readPaperSurfaces(paper);
    if (!rows)
        return rows.error();
    for (const ReproducedModel& model : reproduction.models)
        for (const PaperSurface& row : *rows)
            if (model.table == 1 && model.paper.dataset == row.dataset && model.model) {
                auto surface = measure(host, model, row, progress);
                if (!surface)
                    return surface.error();
                reproduction.surfaces.push_back(*std::move(surface));
            }
    return {};
}

} // namespace

Result<Reproduction> reproduce(PluginHost& host, const std::filesystem::path& data, const std::filesystem::path& folder,
                               const std::set<int>& tables, const Progress& progress)
{
    const auto jobs = jobsFor(data / "paper", tables);
    if (!jobs)
        return jobs.error();
    const std::filesystem::path models = folder / "models";
    std::error_code problem;
    std::filesystem::create_directories(models, problem);
    if (problem)
        return Error{ErrorKind::CannotWrite, "Cannot make the folder '" + models.string() +
                                                 "': " + systemErrorText(problem.value()).text() +
                                                 ". Choose another place with -o."};
    Reproduction reproduction{.tables = tables, .models = {}, .surfaces = {}};
    for (std::size_t number = 0; number < jobs->size(); ++number) {
        if (progress.cancelled())
            return cancelledError("The reproduction");
        const auto share = [&](std::size_t done) {
            return 0.95 * static_cast<double>(done) / static_cast<double>(jobs->size());
        };
        auto model = build(host, (*jobs)[number], data, models, progress.part(share(number), share(number + 1)));
        if (!model)
            return model.error();
        reproduction.models.push_back(*std::move(model));
    }
    if (tables.contains(4))
        if (const Status measured = measureSurfaces(host, reproduction, data / "paper", progress.part(0.95, 1));
            !measured)
            return measured.error();
    return reproduction;
}

} // namespace tetra
