// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/drawing/rectangle.h"
#include "core/render/picking/picking.h"

#include <tan/render.h>

#include <Eigen/Core>

#include <optional>

namespace tetra {

/// From places of the dataset to the pixels of a picture, x to the right and y down, and from movements in the picture
/// to movements in the plane of the view: what projectionMatrix() does to the picture, for those who draw over it.
class PictureProjection {
public:
    PictureProjection(const Camera& camera, const Size& size);

    /// Nothing for a place that is not before the eye.
    std::optional<Eigen::Vector2d> pixelOf(const Eigen::Vector3d& place) const;
    /// The length that a pixel spans in the plane of the view through a place; at least as much as beside the eye.
    double unitsPerPixel(const Eigen::Vector3d& place) const;
    /// How far a step along a unit vector goes in the picture, in pixels for a unit of length.
    Eigen::Vector2d pixelsPerUnit(const Eigen::Vector3d& place, const Eigen::Vector3d& direction) const;
    /// The movement in the plane of the view through a place that is seen as one by these pixels.
    Eigen::Vector3d movement(const Eigen::Vector3d& place, const Eigen::Vector2d& pixels) const;

    /// What is seen at a pixel lies on this line.
    PickingRay pickingRay(const Eigen::Vector2d& pixel) const;

    Eigen::Vector3d right() const { return axes_.col(0); }
    Eigen::Vector3d up() const { return axes_.col(1); }
    Eigen::Vector3d towardsViewer() const { return axes_.col(2); }

private:
    double depthOf(const Eigen::Vector3d& place) const;

    Eigen::Matrix3d axes_;
    Eigen::Vector3d eye_;
    Eigen::Vector2d middle_;
    double distance_;
    double scale_; ///< pixels for a unit of length, one unit before the eye
    bool perspective_;
};

} // namespace tetra
