// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/report_tables.h"

#include "app/command_line/table.h"

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

ReportTable tableOf(const ReproducedModel& model)
{
    ReportTable table{.title = titleOf(model), .rows = {}, .remarks = {}};
    if (!model.model) {
        table.remarks.push_back("Skipped: there is no '" + model.experiment.file.string() + "' in the folder of data.");
        return table;
    }
    const bool curvilinear = model.table == 1;
    table.rows.push_back({curvilinear ? "warping, error %" : "error %", "sites", "paper", "difference %", "tetrahedra",
                          "paper", "difference %"});
    for (const ReproducedLevel& level : model.levels)
        table.rows.push_back({rounded(level.paper.error), std::to_string(level.sites),
                              std::to_string(level.paper.sites),
                              signedPercent(differencePercent(level.sites, level.paper.sites)),
                              std::to_string(level.tetrahedra), std::to_string(level.paper.tetrahedra),
                              signedPercent(differencePercent(level.tetrahedra, level.paper.tetrahedra))});
    table.remarks.push_back("History: " + std::to_string(model.model->tetrahedronCount()) + " tetrahedra, paper " +
                            std::to_string(model.paper.tetrahedra) + ". Built in " + rounded(model.seconds, 3) +
                            " s, paper " + std::to_string(std::lround(model.paper.seconds)) +
                            " s (MIPS R4000, 100 MHz).");
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
    const std::string side = std::to_string(timedPictureSide);
    table.remarks.push_back("Pictures of " + side + " x " + side +
                            " pixels by the processor alone, on all its cores, each from a camera that is new: order, "
                            "projection and filling. The paper's are from an SGI Indigo XS24 with a MIPS R4000, whose "
                            "picture's size is not told.");
    return table;
}

} // namespace

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
        tables.push_back(timeTable(reproduction.surfaces));
    return tables;
}

} // namespace tetra
