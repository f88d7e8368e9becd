// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/comparison_report.h"

#include "app/command_line/table.h"
#include "app/reproduction/chart.h"
#include "app/reproduction/sites_curve.h"

#include <algorithm>

namespace tetra {

namespace {

/// What a build is called in the report.
struct BuildName {
    const char* heading; ///< of its columns
    const char* text;
};

BuildName nameOf(const ComparedBuild& build)
{
    if (build.builder == "refinement")
        return {"refined", "refinement"};
    return build.builder == "decimation" ? BuildName{"decimated", "decimation"}
                                         : BuildName{"in the paper's order", "decimation in the paper's order"};
}

/// How many sites a build has more than the first one that is there, in percent.
std::string differenceCell(const ComparedBuild& build, const ComparedBuild& first, std::size_t level)
{
    const double percent = differencePercent(build.sizes[level].sites, first.sizes[level].sites);
    return (percent > 0 ? "+" : "") + rounded(percent, 3);
}

std::string buildRemark(const ComparedBuild& build)
{
    if (!build.model)
        return "No " + std::string(nameOf(build).text) + ": " + build.refusal;
    std::string text = "By " + std::string(nameOf(build).text) + ": " + rounded(build.seconds, 3) + " s";
    text += build.bytes > 0 ? ", " + byteText(build.bytes) + " of memory besides the dataset" : "";
    text += ", " + std::to_string(build.model->tetrahedronCount()) + " tetrahedra in the history, " +
            std::to_string(build.inverted) + " inverted, " + std::to_string(build.degenerate) +
            " without volume. With " + std::to_string(build.measuredSites) + " sites the error is " +
            rounded(build.error.mean, 3) + " % in the mean, at most " + rounded(build.error.percentile99, 3) +
            " % at 99 of 100 points, and " + rounded(build.error.largest, 3) + " % at the worst.";
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
    std::vector<const ComparedBuild*> builds;
    for (const ComparedBuild& build : dataset.builds)
        if (build.model)
            builds.push_back(&build);
    table.rows.resize(1 + comparedAccuracies.size());
    table.rows[0] = {canWarp(dataset.domain) ? "warping, error %" : "error %"};
    for (std::size_t level = 0; level < comparedAccuracies.size(); ++level)
        table.rows[1 + level] = {rounded(comparedAccuracies[level])};
    const auto addColumn = [&](const std::string& heading, const auto& cell) {
        table.rows[0].push_back(heading);
        for (std::size_t level = 0; level < comparedAccuracies.size(); ++level)
            table.rows[1 + level].push_back(cell(level));
    };
    const auto heading = [&](const char* what, const ComparedBuild* build) {
        return (build == builds.front() ? std::string(what) + ", " : std::string()) + nameOf(*build).heading;
    };
    for (const ComparedBuild* build : builds)
        addColumn(heading("sites", build),
                  [&](std::size_t level) { return std::to_string(build->sizes[level].sites); });
    for (std::size_t number = 1; number < builds.size(); ++number)
        addColumn(number == 1 ? "difference %" : nameOf(*builds[number]).heading,
                  [&](std::size_t level) { return differenceCell(*builds[number], *builds.front(), level); });
    for (const ComparedBuild* build : builds)
        addColumn(heading("tetrahedra", build),
                  [&](std::size_t level) { return std::to_string(build->sizes[level].tetrahedra); });
    for (std::size_t number = 1; number < builds.size(); ++number)
        addColumn((number == 1 ? "% with as many sites, " : "") + std::string(nameOf(*builds[number]).heading),
                  [&](std::size_t level) { return rounded(builds[number]->accuracies[level], 3); });
    for (const ComparedBuild& build : dataset.builds)
        table.remarks.push_back(buildRemark(build));
    return table;
}

JsonObject buildFigures(const ComparedBuild& build)
{
    JsonObject figures{{"builder", build.builder}, {"refused", build.refusal}};
    if (!build.model)
        return figures;
    figures["seconds"] = build.seconds;
    figures["bytes"] = build.bytes;
    figures["tetrahedra"] = build.model->tetrahedronCount();
    figures["inverted"] = build.inverted;
    figures["degenerate"] = build.degenerate;
    figures["measured"] = JsonObject{{"sites", build.measuredSites},
                                     {"mean", build.error.mean},
                                     {"percentile99", build.error.percentile99},
                                     {"largest", build.error.largest}};
    return figures;
}

JsonObject levelFigures(const ComparedDataset& dataset, std::size_t level)
{
    const double percent = comparedAccuracies[level];
    JsonObject figures{{"error", percent}, {"warping", canWarp(dataset.domain) ? percent : 0}};
    for (const ComparedBuild& build : dataset.builds)
        if (build.model)
            figures[build.builder] = JsonObject{{"sites", build.sizes[level].sites},
                                                {"tetrahedra", build.sizes[level].tetrahedra},
                                                {"as_many_sites", build.accuracies[level]}};
    return figures;
}

LineSeries seriesOf(const ComparedDataset& dataset, const ComparedBuild& build, std::size_t colour)
{
    LineSeries series{.name = {}, .ink = seriesInk(colour), .points = {}, .style = LineSeries::Style::Rings};
    if (build.builder == "decimation-paper") {
        series.style = LineSeries::Style::MarkedLine;
        for (std::size_t level = 0; level < comparedAccuracies.size(); ++level)
            if (comparedAccuracies[level] > 0)
                series.points.emplace_back(comparedAccuracies[level], static_cast<double>(build.sizes[level].sites));
        return series;
    }
    series.points = sitesCurve(*build.model);
    if (build.builder == "decimation") {
        series.name = dataset.name;
        series.style = LineSeries::Style::Line;
    }
    return series;
}

LineChart chartOf(DomainClass domain, const std::vector<ComparedDataset>& datasets)
{
    LineChart chart{.texts = {.title = "Sites of the mesh against its error",
                              .note = "Lines: decimation, with marks in the paper's order. Rings: refinement.",
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
        for (const ComparedBuild& build : dataset.builds)
            if (build.model)
                chart.series.push_back(seriesOf(dataset, build, colour));
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

JsonArray comparisonFigures(const std::vector<ComparedDataset>& datasets)
{
    JsonArray array;
    for (const ComparedDataset& dataset : datasets) {
        JsonObject figures{{"dataset", dataset.name}, {"skipped", dataset.skipped}};
        if (dataset.skipped.empty()) {
            JsonArray builds, levels;
            for (const ComparedBuild& build : dataset.builds)
                builds.push_back(buildFigures(build));
            for (std::size_t level = 0; level < comparedAccuracies.size(); ++level)
                levels.push_back(levelFigures(dataset, level));
            figures["domain"] = domainClassName(dataset.domain);
            figures["points"] = dataset.points;
            figures["builds"] = builds;
            figures["levels"] = levels;
        }
        array.push_back(figures);
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
