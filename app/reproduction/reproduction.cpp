// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/reproduction.h"

#include "core/base/memory.h"
#include "core/base/system_error.h"
#include "plugins/host/model_building.h"

#include <tan/query.h>
#include <tan/render.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <tuple>

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
    const bool forgot = forgetPeakResidentBytes();
    const std::uint64_t before = residentBytes();
    const auto built =
        buildModel(host, *result.dataset, "refinement", job.experiment.builderValues, path, progress.part(0.1, 0.9));
    if (!built)
        return built.error();
    result.seconds = built->seconds;
    result.bytes = forgot && built->peakBytes > before ? built->peakBytes - before : 0;
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

/// Surfaces of the paper's isovalue and of one that is larger by a fiftieth of the range of values, and how long it
/// takes to extract the first.
struct TimedSurfaces {
    std::array<TriangleMesh, 2> surfaces;
    double seconds = 0;
};

Result<TimedSurfaces> timeSurfaces(const Model& model, std::uint32_t sites, double isovalue, const Progress& progress)
{
    const auto mesh = extractPrefix(model, sites, progress);
    if (!mesh)
        return mesh.error();
    const ValueRange range = model.description().range;
    TimedSurfaces timed;
    const auto start = std::chrono::steady_clock::now();
    const auto gradients = vertexGradients(*mesh);
    for (std::size_t i = 0; i < 2; ++i) {
        auto surface = extractIsosurface(*mesh, gradients, isovalue + double(i) * 0.02 * range.extent(), progress);
        if (!surface)
            return surface.error();
        timed.surfaces[i] = *std::move(surface);
        if (i == 0)
            timed.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    return timed;
}

/// The three pictures of a row of Table 4.
Status draw(PluginHost& host, const ReproducedModel& model, ReproducedSurface& row, const Progress& progress)
{
    PaperPicture picture;
    picture.isovalues = {Isovalue{row.paper.isovalue}};
    picture.query.error = row.paper.error;
    picture.query.warping = row.paper.warping;
    Picture unused;
    for (const auto& [mode, seconds, target] : {std::tuple("isosurface", &row.times.surface, &row.surfacePicture),
                                                std::tuple("volume", &row.times.volume, &row.volumePicture),
                                                std::tuple("hybrid", &row.times.hybrid, &unused)}) {
        picture.mode = mode;
        auto drawn = drawPicture(host, model.model, picture, progress);
        if (!drawn)
            return drawn.error();
        *seconds = drawn->seconds;
        *target = std::move(drawn->picture);
    }
    return {};
}

/// What the finest mesh of a model looks like.
struct Finest {
    std::array<TriangleMesh, 2> surfaces;
    Picture surfacePicture;
    Picture volumePicture;
};

Result<ReproducedSurface> measure(PluginHost& host, const ReproducedModel& model, const PaperSurface& paper,
                                  std::optional<Finest>& finest, const Progress& progress)
{
    const MeshSize size = meshSizeAt(*model.model, {.error = paper.error, .warping = paper.warping});
    auto timed = timeSurfaces(*model.model, size.sites, paper.isovalue, progress);
    if (!timed)
        return timed.error();
    ReproducedSurface row;
    row.paper = paper;
    row.variant = model.experiment.variant;
    row.sites = size.sites;
    row.tetrahedra = size.tetrahedra;
    row.triangles = timed->surfaces[0].triangles.size();
    row.extractionSeconds = timed->seconds;
    if (const Status drawn = draw(host, model, row, progress); !drawn)
        return drawn.error();
    if (!finest)
        finest = Finest{std::move(timed->surfaces), row.surfacePicture, row.volumePicture};
    else
        row.comparison = compareSurfaces(timed->surfaces, finest->surfaces);
    row.surfaceDegradation = degradationOf(row.surfacePicture, finest->surfacePicture);
    row.volumeDegradation = degradationOf(row.volumePicture, finest->volumePicture);
    return row;
}

/// The finest mesh of each model first.
Status measureSurfaces(PluginHost& host, Reproduction& reproduction, const std::filesystem::path& paper,
                       const Progress& progress)
{
    auto rows = readPaperSurfaces(paper);
    if (!rows)
        return rows.error();
    std::ranges::stable_sort(*rows, {}, &PaperSurface::error);
    for (const ReproducedModel& model : reproduction.models) {
        std::optional<Finest> finest;
        for (const PaperSurface& row : *rows)
            if (model.table == 1 && model.paper.dataset == row.dataset && model.model) {
                auto surface = measure(host, model, row, finest, progress);
                if (!surface)
                    return surface.error();
                reproduction.surfaces.push_back(*std::move(surface));
            }
    }
    return {};
}

/// Fig. 13, several isosurfaces of SOD, and Fig. 15, the buckyball at 0.6 % as volume and surfaces, whose order is that
/// of whole cells.
Status drawOtherFigures(PluginHost& host, Reproduction& reproduction, const Progress& progress)
{
    for (const ReproducedModel& model : reproduction.models) {
        if (!model.model)
            continue;
        const ValueRange range = model.model->description().range;
        const auto at = [&](double share, std::size_t colour, float opacity) {
            const Colour ink = distinctColour(colour);
            return Isovalue{std::lerp(range.minimum, range.maximum, share), ink.red, ink.green, ink.blue, opacity};
        };
        const bool isSod = model.table == 2 && model.paper.dataset == "SOD";
        const bool isBucky = model.table == 3 && model.paper.size[0] == 64;
        if (!isSod && !isBucky)
            continue;
        PaperPicture picture;
        picture.mode = isSod ? "isosurface" : "hybrid";
        if (isSod)
            picture.isovalues = {at(0.15, 1, 0.25f), at(0.35, 2, 0.4f), at(0.6, 0, 1)};
        else
            picture.isovalues = {at(0.6, 0, 0.6f)};
        picture.drawsSurfacesWithCells = isBucky;
        picture.query.error = isSod ? 0 : 0.6;
        auto drawn = drawPicture(host, model.model, picture, progress);
        if (!drawn)
            return drawn.error();
        reproduction.pictures.push_back({isSod ? 13 : 15,
                                         isSod ? "Isosurfaces of SOD"
                                               : "Volume and isosurface of the buckyball at an error of 0.6 %, ordered "
                                                 "by whole cells",
                                         std::move(drawn->picture)});
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
    Reproduction reproduction{.tables = tables, .models = {}, .surfaces = {}, .pictures = {}};
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
        if (const Status measured = measureSurfaces(host, reproduction, data / "paper", progress.part(0.95, 0.99));
            !measured)
            return measured.error();
    if (const Status drawn = drawOtherFigures(host, reproduction, progress.part(0.99, 1)); !drawn)
        return drawn.error();
    return reproduction;
}

} // namespace tetra
