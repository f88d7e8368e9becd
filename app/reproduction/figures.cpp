// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/figures.h"

#include "app/reproduction/chart.h"
#include "app/reproduction/drawing_file.h"
#include "app/reproduction/sites_curve.h"

#include <tan/query.h>

#include <QPainter>

#include <algorithm>

namespace tetra {

namespace {

constexpr QSizeF figureSize(1000, 640);
constexpr QSizeF distributionSize(1200, 560);

QString seriesName(const ReproducedModel& model)
{
    QString name = QString::fromStdString(model.paper.dataset) + QString(" %1").arg(model.paper.size[0]);
    name += model.paper.blockEdge > 0 ? QString(", blocks of %1").arg(model.paper.blockEdge) : QString();
    return name +
           (model.experiment.variant.empty() ? QString() : ", " + QString::fromStdString(model.experiment.variant));
}

Chart sitesAgainstError(const Reproduction& reproduction)
{
    Chart chart{.title = "Sites of the mesh against its error (lines: TAn, rings: the paper's tables)",
                .horizontal = "error, % of the value range",
                .vertical = "sites",
                .series = {}};
    std::size_t colour = 0;
    for (const ReproducedModel& model : reproduction.models) {
        if (!model.model || !reproduction.tables.contains(model.table))
            continue;
        chart.series.push_back({seriesName(model), chartColour(colour), sitesCurve(*model.model)});
        ChartSeries rings{{}, chartColour(colour), {}, false};
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
    QPointF operator()(const Eigen::Vector3d& point) const
    {
        const Eigen::Vector3d seen = rotation_ * (point - centre_);
        return {seen.x(), -seen.y()};
    }

private:
    Eigen::Vector3d centre_;
    Eigen::Matrix3d rotation_;
};

void drawPoints(QPainter& painter, const QRectF& frame, const QString& title, const std::vector<QPointF>& points)
{
    painter.setPen(Qt::black);
    painter.drawText(QRectF(frame.left(), frame.top() + 10, frame.width(), 20), Qt::AlignHCenter, title);
    painter.setPen(Qt::NoPen);
    painter.setBrush(chartColour(0));
    const double scale = 0.95 * frame.width();
    for (const QPointF& point : points)
        painter.drawEllipse(frame.center() + scale * point, 0.7, 0.7);
}

/// Fig. 11.
void drawDistribution(QPainter& painter, const ReproducedModel& model)
{
    const Dataset& dataset = *model.dataset;
    const Projection projection(dataset.bounds());
    std::vector<QPointF> all;
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point)
        all.push_back(projection(dataset.position(point)));
    std::vector<QPointF> some;
    const MeshSize size = meshSizeAt(*model.model, {.error = 2, .warping = 2});
    for (std::uint32_t site = 0; site < size.sites; ++site)
        some.push_back(all[model.model->points()[site]]);

    const QRectF frame(QPointF(0, 0), distributionSize);
    painter.fillRect(frame, Qt::white);
    const double half = frame.width() / 2;
    drawPoints(painter, QRectF(0, 0, half, frame.height()), QString("BluntFin, %1 points").arg(all.size()), all);
    drawPoints(painter, QRectF(half, 0, half, frame.height()),
               QString("warping and error at most 2 %, %1 sites").arg(some.size()), some);
}

} // namespace

Result<std::vector<std::filesystem::path>> drawFigures(const Reproduction& reproduction,
                                                       const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    const auto draw = [&](const std::string& name, const QSizeF& size, const Drawing& drawing) -> Status {
        const auto written = writeDrawing(folder / name, size, drawing);
        if (!written)
            return written.error();
        files.insert(files.end(), written->begin(), written->end());
        return {};
    };

    const Chart chart = sitesAgainstError(reproduction);
    if (!chart.series.empty())
        if (const Status drawn = draw("figure10", figureSize,
                                      [&](QPainter& painter) {
                                          drawChart(painter, {{0, 0}, figureSize}, chart);
                                      });
            !drawn)
            return drawn.error();
    const auto bluntFin = std::ranges::find_if(reproduction.models, [](const ReproducedModel& model) {
        return model.paper.dataset == "BluntFin" && model.model != nullptr;
    });
    if (bluntFin != reproduction.models.end())
        if (const Status drawn =
                draw("figure11", distributionSize, [&](QPainter& painter) { drawDistribution(painter, *bluntFin); });
            !drawn)
            return drawn.error();
    return files;
}

} // namespace tetra
