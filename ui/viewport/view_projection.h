// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/picture_projection.h"

#include <QPointF>
#include <QSizeF>

#include <optional>

namespace tetra {

/// PictureProjection by Qt's points: what is seen where in the viewport.
class ViewProjection {
public:
    ViewProjection(const Camera& camera, QSizeF size) : projection_(camera, {size.width(), size.height()}) {}

    std::optional<QPointF> pixelOf(const Eigen::Vector3d& place) const
    {
        const auto pixel = projection_.pixelOf(place);
        return pixel ? std::optional(pointOf(*pixel)) : std::nullopt;
    }
    double unitsPerPixel(const Eigen::Vector3d& place) const { return projection_.unitsPerPixel(place); }
    QPointF pixelsPerUnit(const Eigen::Vector3d& place, const Eigen::Vector3d& direction) const
    {
        return pointOf(projection_.pixelsPerUnit(place, direction));
    }
    Eigen::Vector3d movement(const Eigen::Vector3d& place, QPointF pixels) const
    {
        return projection_.movement(place, {pixels.x(), pixels.y()});
    }
    PickingRay pickingRay(QPointF pixel) const { return projection_.pickingRay({pixel.x(), pixel.y()}); }

    Eigen::Vector3d right() const { return projection_.right(); }
    Eigen::Vector3d up() const { return projection_.up(); }
    Eigen::Vector3d towardsViewer() const { return projection_.towardsViewer(); }

private:
    static QPointF pointOf(const Eigen::Vector2d& place) { return {place.x(), place.y()}; }

    PictureProjection projection_;
};

} // namespace tetra
