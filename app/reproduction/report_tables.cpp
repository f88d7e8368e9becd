// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/report_tables.h"

#include "app/command_line/table.h"

#include <tan/query.h>

#include <cmath>

namespace tetra {

namespace {

std::string signedPercent(double percent)
{
    return (percent > 0 ? "+" : "") + rounded(percent, 3);
}

std::string titleOf(const ReproducedModel& model)
{
    std::string title = "Table " + std::to_string(model.table) + ", " + model.paper.dataset;
    for (std::size_t axis = 0; axis < 3; ++axis)
        title += (axis == 0 ? " " : " x ") + std::to_string(model.paper.size[axis]);
    if (model.paper.blockEdge > 0)
        title += ", blocks of " + std::to_string(model.paper.blockEdge);
    if (!model.experiment.variant.empty())
        title += ", " + model.experiment.variant;
    return title;
}

std::string megabytes(std::uint64_t bytes)
{
    return rounded(static_cast<double>(bytes) / 1e6, 3) + " MB";
}

ReportTable tableOf(const ReproducedModel& model)
{
    ReportTable table{.title = titleOf(model), .rows = {}, .remarks = {}};
    if (!model.model) {
        table.remarks.push_back("Skipped: there is no '" + model.experiment.file.string() + "' in the folder of data.");
        return table;
    }
    const bool curvilinear = model.table == 1;
    const auto points = static_cast<double>(model.dataset->pointCount());
    table.rows.push_back({curvilinear ? "warping, error %" : "error %", "sites", "paper", "difference %",
                          "sites of all %", "paper", "tetrahedra", "paper", "difference %"});
    for (const ReproducedLevel& level : model.levels)
        table.rows.push_back(
            {rounded(level.paper.error), std::to_string(level.sites), std::to_string(level.paper.sites),
             signedPercent(differencePercent(level.sites, level.paper.sites)),
             rounded(100 * static_cast<double>(level.sites) / points, 3), rounded(level.paper.sitesPercent),
             std::to_string(level.tetrahedra), std::to_string(level.paper.tetrahedra),
             signedPercent(differencePercent(level.tetrahedra, level.paper.tetrahedra))});
    table.remarks.push_back(
        "History: " + std::to_string(model.model->tetrahedronCount()) + " tetrahedra, paper " +
        std::to_string(model.paper.tetrahedra) + ". Built in " + rounded(model.seconds, 3) + " s, paper " +
        std::to_string(std::lround(model.paper.seconds)) + " s (MIPS R4000, 100 MHz). Memory: " +
        (model.bytes == 0 ? "unknown" : megabytes(model.bytes)) + ", paper " + megabytes(model.paper.bytes) + ".");
    if (const auto [ours, paper] = historyRatios(model); ours > 0)
        table.remarks.push_back("The history has " + rounded(ours, 3) + " times the tetrahedra of the finest mesh" +
                                (paper > 0 ? ", in the paper " + rounded(paper, 3) + "." : "."));
    if (curvilinear)
        table.remarks.push_back("Finest mesh: " + std::to_string(model.inverted) + " tetrahedra inverted, " +
                                std::to_string(model.degenerate) + " without volume.");
    if (!model.experiment.caveat.empty())
        table.remarks.push_back(model.experiment.caveat);
    return table;
}

ReportTable surfaceTable(const std::vector<ReproducedSurface>& surfaces)
{
    ReportTable table{.title = "Table 4, isosurfaces of BluntFin", .rows = {}, .remarks = {}};
    if (surfaces.empty()) {
        table.remarks.emplace_back("Skipped: there are no data.");
        return table;
    }
    table.rows.push_back({"model", "isovalue", "warping, error %", "sites", "paper", "tetrahedra", "paper", "triangles",
                          "paper", "difference %"});
    for (const ReproducedSurface& surface : surfaces)
        table.rows.push_back({surface.variant, rounded(surface.paper.isovalue), rounded(surface.paper.error),
                              std::to_string(surface.sites), std::to_string(surface.paper.sites),
                              std::to_string(surface.tetrahedra), std::to_string(surface.paper.tetrahedra),
                              std::to_string(surface.triangles), std::to_string(surface.paper.triangles),
                              signedPercent(differencePercent(surface.triangles, surface.paper.triangles))});
    table.remarks.emplace_back("Triangles that lie wholly on one vertex or edge are left out here; the paper does not "
                               "say whether it kept them.");
    return table;
}

ReportTable timeTable(const std::vector<ReproducedSurface>& surfaces)
{
    ReportTable table{.title = "Table 4, drawing of BluntFin, in seconds", .rows = {}, .remarks = {}};
    table.rows.push_back({"model", "warping, error %", "tetrahedra", "isosurface", "surface drawn", "volume", "paper",
                          "ratio", "hybrid"});
    for (const ReproducedSurface& surface : surfaces)
        table.rows.push_back({surface.variant, rounded(surface.paper.error), std::to_string(surface.tetrahedra),
                              rounded(surface.extractionSeconds, 3), rounded(surface.times.surface, 3),
                              rounded(surface.times.volume, 3), rounded(surface.paper.volumeSeconds),
                              rounded(surface.paper.volumeSeconds / surface.times.volume, 3),
                              rounded(surface.times.hybrid, 3)});
    const std::string side = std::to_string(paperPictureSide);
    table.remarks.push_back("Pictures of " + side + " x " + side +
                            " pixels by the processor alone, on all its cores, each from a camera that is new: order, "
                            "projection and filling. The paper's are from an SGI Indigo XS24 with a MIPS R4000, whose "
                            "picture's size is not told.");
    return table;
}

/// Fig. 14 in numbers: how far the pictures are off those of the finest mesh.
ReportTable degradationTable(const std::vector<ReproducedSurface>& surfaces)
{
    ReportTable table{
        .title = "Figure 14, pictures of BluntFin beside those of the finest mesh", .rows = {}, .remarks = {}};
    table.rows.push_back({"model", "warping, error %", "tetrahedra", "isosurface, root mean square %",
                          "pixels that differ %", "volume, root mean square %", "pixels that differ %"});
    for (const ReproducedSurface& surface : surfaces)
        table.rows.push_back({surface.variant, rounded(surface.paper.error), std::to_string(surface.tetrahedra),
                              rounded(surface.surfaceDegradation.rootMeanSquare, 3),
                              rounded(surface.surfaceDegradation.visiblePercent, 3),
                              rounded(surface.volumeDegradation.rootMeanSquare, 3),
                              rounded(surface.volumeDegradation.visiblePercent, 3)});
    table.remarks.emplace_back(
        "Of the pixels where one of the two pictures shows something; those that differ do so by "
        "more than a tenth in some colour. The paper calls it almost unperceivable at 1 %, still "
        "small at 4 %.");
    return table;
}

/// Section 6: surfaces of simplified data beside the simplified surface of all data.
ReportTable comparisonTable(const std::vector<ReproducedSurface>& surfaces)
{
    ReportTable table{
        .title = "Section 6, isosurfaces of simplified data beside simplified isosurfaces", .rows = {}, .remarks = {}};
    table.rows.push_back({"model", "warping, error %", "triangles", "distance %", "largest", "crossings", "simplified",
                          "distance %", "largest", "crossings", "s"});
    for (const ReproducedSurface& surface : surfaces) {
        const auto& [data, simplified, seconds] = surface.comparison;
        if (data.triangles > 0)
            table.rows.push_back({surface.variant, rounded(surface.paper.error), std::to_string(data.triangles),
                                  rounded(data.rootMeanSquare, 3), rounded(data.largest, 3),
                                  std::to_string(data.crossings), std::to_string(simplified.triangles),
                                  rounded(simplified.rootMeanSquare, 3), rounded(simplified.largest, 3),
                                  std::to_string(simplified.crossings), rounded(seconds, 3)});
    }
    table.remarks.emplace_back(
        "Simplified: the surface of the finest mesh by edge collapse (Lindstrom and Turk, in CGAL) to as many "
        "triangles, "
        "which knows the surface alone and cannot tell where it lies in the data. Distance: of the finest surface's "
        "vertices from this one, root mean square, % of the surface's diagonal. Crossings: triangles that meet the "
        "surface, "
        "made likewise, of a value that is larger by 2 % of the range; surfaces of one mesh have none, as the paper "
        "says.");
    return table;
}

} // namespace

HistoryRatios historyRatios(const ReproducedModel& model)
{
    HistoryRatios ratios;
    if (!model.model)
        return ratios;
    const MeshSize finest = meshSizeAt(*model.model, {});
    ratios.ours = static_cast<double>(model.model->tetrahedronCount()) / static_cast<double>(finest.tetrahedra);
    for (const PaperLevel& level : model.paper.levels)
        if (level.error == 0)
            ratios.paper = static_cast<double>(model.paper.tetrahedra) / static_cast<double>(level.tetrahedra);
    return ratios;
}

double differencePercent(std::uint64_t ours, std::uint64_t paper)
{
    return 100 * (static_cast<double>(ours) / static_cast<double>(paper) - 1);
}

std::vector<ReportTable> reportTables(const Reproduction& reproduction)
{
    std::vector<ReportTable> tables;
    for (const ReproducedModel& model : reproduction.models)
        if (reproduction.tables.contains(model.table))
            tables.push_back(tableOf(model));
    if (reproduction.tables.contains(4))
        tables.push_back(surfaceTable(reproduction.surfaces));
    if (reproduction.tables.contains(4) && !reproduction.surfaces.empty())
        for (const auto& make : {timeTable, degradationTable, comparisonTable})
            tables.push_back(make(reproduction.surfaces));
    return tables;
}

} // namespace tetra
