// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/report.h"

#include "app/reproduction/report_tables.h"
#include "app/reproduction/report_text.h"

#include <QJsonArray>

namespace tetra {

namespace {

QString asQString(const std::string& text)
{
    return QString::fromStdString(text);
}

QJsonObject meshFigures(std::uint64_t sites, std::uint64_t tetrahedra)
{
    return {{"sites", static_cast<qint64>(sites)}, {"tetrahedra", static_cast<qint64>(tetrahedra)}};
}

QJsonObject levelFigures(std::uint64_t sites, std::uint64_t tetrahedra, double sitesPercent)
{
    QJsonObject figures = meshFigures(sites, tetrahedra);
    figures["sites_percent"] = sitesPercent;
    return figures;
}

void addRows(const ReproducedModel& model, QJsonArray& rows)
{
    const double points = model.dataset ? static_cast<double>(model.dataset->pointCount()) : 0;
    for (const ReproducedLevel& level : model.levels)
        rows.append(QJsonObject{
            {"dataset", asQString(model.paper.dataset)},
            {"size", QJsonArray{static_cast<qint64>(model.paper.size[0]), static_cast<qint64>(model.paper.size[1]),
                                static_cast<qint64>(model.paper.size[2])}},
            {"block", static_cast<qint64>(model.paper.blockEdge)},
            {"variant", asQString(model.experiment.variant)},
            {"error", level.paper.error},
            {"warping", level.paper.warping},
            {"paper", levelFigures(level.paper.sites, level.paper.tetrahedra, level.paper.sitesPercent)},
            {"ours", levelFigures(level.sites, level.tetrahedra, 100 * static_cast<double>(level.sites) / points)},
            {"difference", QJsonObject{{"sites", differencePercent(level.sites, level.paper.sites)},
                                       {"tetrahedra", differencePercent(level.tetrahedra, level.paper.tetrahedra)}}}});
}

QJsonObject modelFigures(const ReproducedModel& model)
{
    QJsonObject figures{{"dataset", asQString(model.paper.dataset)},
                        {"variant", asQString(model.experiment.variant)},
                        {"caveat", asQString(model.experiment.caveat)},
                        {"skipped", model.model == nullptr}};
    if (model.model == nullptr)
        return figures;
    const HistoryRatios ratios = historyRatios(model);
    figures["paper"] = QJsonObject{{"tetrahedra", static_cast<qint64>(model.paper.tetrahedra)},
                                   {"seconds", model.paper.seconds},
                                   {"bytes", static_cast<qint64>(model.paper.bytes)},
                                   {"of_finest_mesh", ratios.paper}};
    figures["ours"] = QJsonObject{{"tetrahedra", static_cast<qint64>(model.model->tetrahedronCount())},
                                  {"seconds", model.seconds},
                                  {"bytes", static_cast<qint64>(model.bytes)},
                                  {"of_finest_mesh", ratios.ours},
                                  {"inverted", static_cast<qint64>(model.inverted)},
                                  {"degenerate", static_cast<qint64>(model.degenerate)}};
    return figures;
}

QJsonObject degradationFigures(const Degradation& degradation)
{
    return {{"root_mean_square", degradation.rootMeanSquare}, {"pixels", degradation.visiblePercent}};
}

QJsonObject qualityFigures(const SurfaceQuality& quality)
{
    return {{"triangles", static_cast<qint64>(quality.triangles)},
            {"distance", quality.rootMeanSquare},
            {"largest_distance", quality.largest},
            {"crossings", static_cast<qint64>(quality.crossings)}};
}

QJsonObject surfaceFigures(const ReproducedSurface& surface)
{
    QJsonObject paper = meshFigures(surface.paper.sites, surface.paper.tetrahedra);
    paper["triangles"] = static_cast<qint64>(surface.paper.triangles);
    paper["volume_seconds"] = surface.paper.volumeSeconds;
    QJsonObject ours = meshFigures(surface.sites, surface.tetrahedra);
    ours["triangles"] = static_cast<qint64>(surface.triangles);
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
    return {{"dataset", asQString(surface.paper.dataset)},
            {"variant", asQString(surface.variant)},
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

QJsonObject jsonReport(const Reproduction& reproduction)
{
    QJsonArray tables;
    for (const int number : reproduction.tables) {
        QJsonArray rows;
        QJsonArray models;
        for (const ReproducedModel& model : reproduction.models)
            if (model.table == number) {
                addRows(model, rows);
                models.append(modelFigures(model));
            }
        if (number == 4)
            for (const ReproducedSurface& surface : reproduction.surfaces)
                rows.append(surfaceFigures(surface));
        QJsonObject figures{{"table", number}, {"rows", rows}};
        if (!models.isEmpty())
            figures["models"] = models;
        tables.append(figures);
    }
    return {{"tables", tables}};
}

} // namespace tetra
