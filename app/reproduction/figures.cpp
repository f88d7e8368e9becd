// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/figures.h"

#include "app/command_line/table.h"
#include "app/reproduction/chart.h"
#include "app/reproduction/sites_curve.h"
#include "core/picture/png_file.h"

#include <tan/query.h>

#include <algorithm>

namespace tetra {

namespace {

constexpr double distributionWidth = 1200, distributionHeight = 560;

std::string seriesName(const ReproducedModel& model)
{
    std::string name = model.paper.dataset + ' ' + std::to_string(model.paper.size[0]);
    if (model.paper.blockEdge > 0)
        name += ", blocks of " + std::to_string(model.paper.blockEdge);
    return name + (model.experiment.variant.empty() ? "" : ", " + model.experiment.variant);
}

LineChart sitesAgainstError(const Reproduction& reproduction)
{
    LineChart chart{.texts = {.title = "Sites of the mesh against its error",
                              .note = "Lines: TAn. Rings: the paper's tables.",
                              .unit = "sites",
                              .description = "The numbers of sites are in the tables of this reproduction."},
                    .across = "error, % of the value range",
                    .series = {},
                    .size = {1000, 640}};
    std::size_t colour = 0;
    for (const ReproducedModel& model : reproduction.models) {
        if (!model.model || !reproduction.tables.contains(model.table))
            continue;
        chart.series.push_back(
            {.name = seriesName(model), .ink = seriesInk(colour), .points = sitesCurve(*model.model)});
        LineSeries rings{.name = {}, .ink = seriesInk(colour), .points = {}, .style = LineSeries::Style::Rings};
        for (const ReproducedLevel& level : model.levels)
            if (level.paper.error > 0)
                rings.points.emplace_back(level.paper.error, static_cast<double>(level.paper.sites));
        chart.series.push_back(rings);
        ++colour;
    }
    return chart;
}

/// Points of a dataset seen from a direction that shows all three of its axes, in a square of side 1.
class Projection {
public:
    explicit Projection(const Eigen::AlignedBox3d& bounds) : centre_(bounds.center())
    {
        const Eigen::AngleAxisd turn(-0.5, Eigen::Vector3d::UnitZ());
        const Eigen::AngleAxisd tilt(-1.1, Eigen::Vector3d::UnitX());
        rotation_ = (tilt * turn).toRotationMatrix() / bounds.diagonal().norm();
    }
    Eigen::Vector2d operator()(const Eigen::Vector3d& point) const
    {
        const Eigen::Vector3d seen = rotation_ * (point - centre_);
        return {seen.x(), -seen.y()};
    }

private:
    Eigen::Vector3d centre_;
    Eigen::Matrix3d rotation_;
};

/// A title, and the points below it, in a half of the drawing.
void drawPoints(Drawing& drawing, double left, const std::string& title, const Points& points)
{
    const double width = distributionWidth / 2;
    const Eigen::Vector2d centre(left + width / 2, distributionHeight / 2);
    drawing.text({centre.x(), 26}, title, Letters::Plain, Anchor::Middle);
    Points places;
    for (const Eigen::Vector2d& point : points)
        places.emplace_back(centre + 0.95 * width * point);
    drawing.dots(places, seriesInk(0), 1.4);
}

/// Fig. 11.
Drawing distribution(const ReproducedModel& model)
{
    const Dataset& dataset = *model.dataset;
    const Projection projection(dataset.bounds());
    Points all, some;
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point)
        all.push_back(projection(dataset.position(point)));
    const MeshSize size = meshSizeAt(*model.model, {.error = 2, .warping = 2});
    for (std::uint32_t site = 0; site < size.sites; ++site)
        some.push_back(all[model.model->points()[site]]);
    const std::string allTitle = "BluntFin, " + std::to_string(all.size()) + " points";
    const std::string someTitle = "warping and error at most 2 %, " + std::to_string(some.size()) + " sites";
    Drawing drawing({distributionWidth, distributionHeight}, "Where the vertices lie",
                    allTitle + "; " + someTitle + '.');
    drawPoints(drawing, 0, allTitle, all);
    drawPoints(drawing, distributionWidth / 2, someTitle, some);
    return drawing;
}

} // namespace

Result<std::vector<std::filesystem::path>> drawFigures(const Reproduction& reproduction,
                                                       const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    const auto write = [&](const std::string& name, const Drawing& drawing) -> Status {
        const auto written = writeDrawing(folder / name, drawing);
        if (!written)
            return written.error();
        files.insert(files.end(), written->begin(), written->end());
        return {};
    };

    const LineChart chart = sitesAgainstError(reproduction);
    if (!chart.series.empty())
        if (const Status written = write("figure10", drawChart(chart)); !written)
            return written.error();
    const auto bluntFin = std::ranges::find_if(reproduction.models, [](const ReproducedModel& model) {
        return model.paper.dataset == "BluntFin" && model.model != nullptr;
    });
    if (bluntFin != reproduction.models.end())
        if (const Status written = write("figure11", distribution(*bluntFin)); !written)
            return written.error();
    const auto keep = [&](const std::string& name, const Picture& picture) -> Status {
        files.push_back(folder / (name + ".png"));
        return writePicture(picture, files.back());
    };
    for (const ReproducedPicture& picture : reproduction.pictures)
        if (const Status written = keep("figure" + std::to_string(picture.figure), picture.picture); !written)
            return written.error();
    for (const ReproducedSurface& row : reproduction.surfaces)
        if (row.variant == reproduction.surfaces.front().variant)
            for (const auto& [what, picture] :
                 {std::pair("isosurface", &row.surfacePicture), std::pair("volume", &row.volumePicture)})
                if (const Status written =
                        keep("figure14-" + std::string(what) + "-" + rounded(row.paper.error), *picture);
                    !written)
                    return written.error();
    return files;
}

} // namespace tetra
