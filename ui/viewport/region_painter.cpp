// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/region_painter.h"

#include <QPainter>

namespace tetra {
namespace {

constexpr double handleRadius = 5; ///< pixels
constexpr double hoveredRadius = 7;
constexpr double hiddenOpacity = 0.5;

void drawLine(QPainter& painter, const ViewProjection& projection, const Eigen::Vector3d& one,
              const Eigen::Vector3d& other)
{
    const auto from = projection.pixelOf(one);
    const auto to = projection.pixelOf(other);
    if (from && to)
        painter.drawLine(*from, *to);
}

void paintOutline(QPainter& painter, const ViewProjection& projection, const MovableRegion& place,
                  const RegionLook& look)
{
    QColor colour = look.colour;
    colour.setAlphaF(look.dragged ? 1 : hiddenOpacity);
    painter.setPen(QPen(colour, look.dragged ? 1.5 : 1));
    const LineSet lines = outlineOf(place, {}, 1);
    for (const auto& [first, second] : lines.segments)
        drawLine(painter, projection, lines.points[first].cast<double>(), lines.points[second].cast<double>());
}

/// The centre is round, and hollow if it is selected; what changes the size is square.
void paintHandle(QPainter& painter, const RegionHandle& handle, QPointF place, const RegionLook& look)
{
    const bool hovered = look.hovered && look.hovered->isSameAs(handle);
    const double radius = hovered ? hoveredRadius : handleRadius;
    painter.setPen(QPen(look.rim, 1.5));
    painter.setBrush(look.colour);
    if (handle.kind != RegionHandle::Kind::Centre)
        return painter.drawRect(QRectF(place.x() - radius, place.y() - radius, 2 * radius, 2 * radius));
    painter.drawEllipse(place, radius + 1, radius + 1);
    if (!look.selected)
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(look.rim);
    painter.drawEllipse(place, radius / 2.5, radius / 2.5);
}

} // namespace

QColor regionColour(RegionKind kind, const QColor& ground)
{
    const bool dark = ground.lightness() < 128;
    if (kind == RegionKind::Focus)
        return dark ? QColor(108, 182, 255) : QColor(16, 92, 190);
    return dark ? QColor(225, 225, 225) : QColor(60, 60, 60);
}

void paintRegion(QPainter& painter, const ViewProjection& projection, const MovableRegion& place,
                 const std::vector<RegionHandle>& handles, const RegionLook& look)
{
    paintOutline(painter, projection, place, look);
    for (const RegionHandle& handle : handles)
        if (const auto pixel = projection.pixelOf(handle.place))
            paintHandle(painter, handle, *pixel, look);
}

void paintAxis(QPainter& painter, const ViewProjection& projection, const Eigen::Vector3d& centre, int axis,
               double half, const QColor& colour)
{
    painter.setPen(QPen(colour, 1, Qt::DashLine));
    const Eigen::Vector3d along = half * Eigen::Vector3d::Unit(axis);
    drawLine(painter, projection, centre - along, centre + along);
}

} // namespace tetra
