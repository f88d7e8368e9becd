// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/report.h"

#include "app/reproduction/report_tables.h"
#include "app/reproduction/report_text.h"

namespace tetra {

namespace {

JsonObject meshFigures(std::uint64_t sites, std::uint64_t tetrahedra)
{
    return {{"sites", sites}, {"tetrahedra", tetrahedra}};
}

JsonObject levelFigures(std::uint64_t sites, std::uint64_t tetrahedra, double sitesPercent)
{
    JsonObject figures = meshFigures(sites, tetrahedra);
    figures["sites_percent"] = sitesPercent;
    return figures;
}

void addRows(const ReproducedModel& model, JsonArray& rows)
{
    const double points = model.dataset ? static_cast<double>(model.dataset->pointCount()) : 0;
    for (const ReproducedLevel& level : model.levels)
        rows.push_back(JsonObject{
            {"dataset", model.paper.dataset},
            {"size", JsonArray{model.paper.size[0], model.paper.size[1], model.paper.size[2]}},
            {"block", model.paper.blockEdge},
            {"variant", model.experiment.variant},
            {"error", level.paper.error},
            {"warping", level.paper.warping},
            {"paper", levelFigures(level.paper.sites, level.paper.tetrahedra, level.paper.sitesPercent)},
            {"ours", levelFigures(level.sites, level.tetrahedra, 100 * static_cast<double>(level.sites) / points)},
            {"difference", JsonObject{{"sites", differencePercent(level.sites, level.paper.sites)},
                                      {"tetrahedra", differencePercent(level.tetrahedra, level.paper.tetrahedra)}}}});
}

JsonObject modelFigures(const ReproducedModel& model)
{
    JsonObject figures{{"dataset", model.paper.dataset},
                       {"variant", model.experiment.variant},
                       {"caveat", model.experiment.caveat},
                       {"skipped", model.model == nullptr}};
    if (model.model == nullptr)
        return figures;
    const HistoryRatios ratios = historyRatios(model);
    figures["paper"] = JsonObject{{"tetrahedra", model.paper.tetrahedra},
                                  {"seconds", model.paper.seconds},
                                  {"bytes", model.paper.bytes},
                                  {"of_finest_mesh", ratios.paper}};
    figures["ours"] = JsonObject{{"tetrahedra", model.model->tetrahedronCount()},
                                 {"seconds", model.seconds},
                                 {"bytes", model.bytes},
                                 {"of_finest_mesh", ratios.ours},
                                 {"inverted", model.inverted},
                                 {"degenerate", model.degenerate}};
    return figures;
}

JsonObject degradationFigures(const Degradation& degradation)
{
    return {{"root_mean_square", degradation.rootMeanSquare}, {"pixels", degradation.visiblePercent}};
}

JsonObject qualityFigures(const SurfaceQuality& quality)
{
    return {{"triangles", quality.triangles},
            {"distance", quality.rootMeanSquare},
            {"largest_distance", quality.largest},
            {"crossings", quality.crossings}};
}

JsonObject surfaceFigures(const ReproducedSurface& surface)
{
    JsonObject paper = meshFigures(surface.paper.sites, surface.paper.tetrahedra);
    paper["triangles"] = surface.paper.triangles;
    paper["volume_seconds"] = surface.paper.volumeSeconds;
    JsonObject ours = meshFigures(surface.sites, surface.tetrahedra);
    ours["triangles"] = surface.triangles;
    ours["extraction_seconds"] = surface.extractionSeconds;
    ours["surface_seconds"] = surface.times.surface;
    ours["volume_seconds"] = surface.times.volume;
    ours["hybrid_seconds"] = surface.times.hybrid;
    ours["surface_degradation"] = degradationFigures(surface.surfaceDegradation);
    ours["volume_degradation"] = degradationFigures(surface.volumeDegradation);
    if (surface.comparison.fromData.triangles > 0) {
        ours["surface"] = qualityFigures(surface.comparison.fromData);
        ours["simplified"] = qualityFigures(surface.comparison.simplified);
        ours["simplifying_seconds"] = surface.comparison.simplifyingSeconds;
    }
    return {{"dataset", surface.paper.dataset},
            {"variant", surface.variant},
            {"isovalue", surface.paper.isovalue},
            {"error", surface.paper.error},
            {"warping", surface.paper.warping},
            {"paper", paper},
            {"ours", ours}};
}

} // namespace

std::string textReport(const Reproduction& reproduction)
{
    return textOf(reportTables(reproduction));
}

std::string markdownReport(const Reproduction& reproduction)
{
    return markdownOf("The paper's tables, made again", reportTables(reproduction));
}

JsonObject jsonReport(const Reproduction& reproduction)
{
    JsonArray tables;
    for (const int number : reproduction.tables) {
        JsonArray rows;
        JsonArray models;
        for (const ReproducedModel& model : reproduction.models)
            if (model.table == number) {
                addRows(model, rows);
                models.push_back(modelFigures(model));
            }
        if (number == 4)
            for (const ReproducedSurface& surface : reproduction.surfaces)
                rows.push_back(surfaceFigures(surface));
        JsonObject figures{{"table", number}, {"rows", rows}};
        if (!models.empty())
            figures["models"] = models;
        tables.push_back(figures);
    }
    return {{"tables", tables}};
}

} // namespace tetra
