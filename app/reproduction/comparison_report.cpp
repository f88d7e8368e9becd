// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/comparison_report.h"

#include "app/command_line/table.h"
#include "app/reproduction/chart.h"
#include "app/reproduction/sites_curve.h"

#include <QJsonObject>

#include <algorithm>

namespace tetra {

namespace {

std::string sizeCell(const ComparedBuild& build, std::size_t level, std::uint64_t ComparedBuild::Size::*figure)
{
    return build.model ? std::to_string(build.sizes[level].*figure) : "-";
}

/// How many sites decimation has more than refinement, in percent.
std::string differenceCell(const ComparedDataset& dataset, std::size_t level)
{
    const ComparedBuild &refined = dataset.builds[0], &decimated = dataset.builds[1];
    if (!refined.model || !decimated.model)
        return "-";
    const double percent = differencePercent(decimated.sizes[level].sites, refined.sizes[level].sites);
    return (percent > 0 ? "+" : "") + rounded(percent, 3);
}

std::string buildRemark(const ComparedBuild& build)
{
    if (!build.model)
        return "No " + build.builder + ": " + build.refusal;
    std::string text = "By " + build.builder + ": " + rounded(build.seconds, 3) + " s";
    text += build.bytes > 0 ? ", " + byteText(build.bytes) + " of memory besides the dataset" : "";
    text += ", " + std::to_string(build.model->tetrahedronCount()) + " tetrahedra in the history, " +
            std::to_string(build.inverted) + " inverted, " + std::to_string(build.degenerate) + " without volume.";
    return text;
}

ReportTable tableOf(const ComparedDataset& dataset)
{
    ReportTable table{.title = dataset.name, .rows = {}, .remarks = {}};
    if (!dataset.skipped.empty()) {
        table.remarks.push_back("Skipped. " + dataset.skipped);
        return table;
    }
    table.title +=
        ", " + std::string(domainClassName(dataset.domain)) + ", " + std::to_string(dataset.points) + " points";
    table.rows.push_back({canWarp(dataset.domain) ? "warping, error %" : "error %", "sites, refined", "decimated",
                          "difference %", "tetrahedra, refined", "decimated"});
    for (std::size_t level = 0; level < comparedAccuracies.size(); ++level)
        table.rows.push_back(
            {rounded(comparedAccuracies[level]), sizeCell(dataset.builds[0], level, &ComparedBuild::Size::sites),
             sizeCell(dataset.builds[1], level, &ComparedBuild::Size::sites), differenceCell(dataset, level),
             sizeCell(dataset.builds[0], level, &ComparedBuild::Size::tetrahedra),
             sizeCell(dataset.builds[1], level, &ComparedBuild::Size::tetrahedra)});
    for (const ComparedBuild& build : dataset.builds)
        table.remarks.push_back(buildRemark(build));
    return table;
}

QJsonObject buildFigures(const ComparedBuild& build)
{
    QJsonObject figures{{"builder", QString::fromStdString(build.builder)},
                        {"refused", QString::fromStdString(build.refusal)}};
    if (!build.model)
        return figures;
    figures["seconds"] = build.seconds;
    figures["bytes"] = static_cast<qint64>(build.bytes);
    figures["tetrahedra"] = static_cast<qint64>(build.model->tetrahedronCount());
    figures["inverted"] = static_cast<qint64>(build.inverted);
    figures["degenerate"] = static_cast<qint64>(build.degenerate);
    return figures;
}

QJsonObject levelFigures(const ComparedDataset& dataset, std::size_t level)
{
    const double percent = comparedAccuracies[level];
    QJsonObject figures{{"error", percent}, {"warping", canWarp(dataset.domain) ? percent : 0}};
    for (const ComparedBuild& build : dataset.builds)
        if (build.model)
            figures[QString::fromStdString(build.builder)] =
                QJsonObject{{"sites", static_cast<qint64>(build.sizes[level].sites)},
                            {"tetrahedra", static_cast<qint64>(build.sizes[level].tetrahedra)}};
    return figures;
}

LineChart chartOf(DomainClass domain, const std::vector<ComparedDataset>& datasets)
{
    LineChart chart{.texts = {.title = "Sites of the mesh against its error",
                              .note = "Lines: decimation. Rings: refinement.",
                              .unit = "sites",
                              .description = "The numbers of sites are in the tables of this comparison."},
                    .across = domain == DomainClass::RegularLattice
                                  ? "error, % of the value range"
                                  : "error, % of the value range, and warping, % of the diagonal",
                    .series = {},
                    .size = {1000, 640}};
    std::size_t colour = 0;
    for (const ComparedDataset& dataset : datasets) {
        if (!dataset.skipped.empty() || dataset.domain != domain)
            continue;
        for (const ComparedBuild& build : dataset.builds) {
            const bool isLine = build.builder == "decimation";
            if (build.model)
                chart.series.push_back({.name = isLine ? QString::fromStdString(dataset.name) : QString(),
                                        .ink = seriesInk(colour),
                                        .points = sitesCurve(*build.model),
                                        .style = isLine ? LineSeries::Style::Line : LineSeries::Style::Rings});
        }
        ++colour;
    }
    return chart;
}

} // namespace

std::vector<ReportTable> comparisonTables(const std::vector<ComparedDataset>& datasets)
{
    std::vector<ReportTable> tables;
    std::ranges::transform(datasets, std::back_inserter(tables), tableOf);
    return tables;
}

QJsonArray comparisonFigures(const std::vector<ComparedDataset>& datasets)
{
    QJsonArray array;
    for (const ComparedDataset& dataset : datasets) {
        QJsonObject figures{{"dataset", QString::fromStdString(dataset.name)},
                            {"skipped", QString::fromStdString(dataset.skipped)}};
        if (dataset.skipped.empty()) {
            QJsonArray builds, levels;
            for (const ComparedBuild& build : dataset.builds)
                builds.append(buildFigures(build));
            for (std::size_t level = 0; level < comparedAccuracies.size(); ++level)
                levels.append(levelFigures(dataset, level));
            figures["domain"] = QString::fromStdString(std::string(domainClassName(dataset.domain)));
            figures["points"] = static_cast<qint64>(dataset.points);
            figures["builds"] = builds;
            figures["levels"] = levels;
        }
        array.append(figures);
    }
    return array;
}

Result<std::vector<std::filesystem::path>> drawComparison(const std::vector<ComparedDataset>& datasets,
                                                          const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    for (const DomainClass domain : {DomainClass::RegularLattice, DomainClass::Curvilinear, DomainClass::Irregular}) {
        const LineChart chart = chartOf(domain, datasets);
        if (chart.series.empty())
            continue;
        const auto written =
            writeDrawing(folder / ("builders-" + std::string(domainClassName(domain))), drawChart(chart));
        if (!written)
            return written.error();
        files.insert(files.end(), written->begin(), written->end());
    }
    return files;
}

} // namespace tetra
