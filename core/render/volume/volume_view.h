// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/view_transform.h"

#include <tan/render.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tetra {

/// A camera made ready to draw a volume into `width` x `height` samples.
///
/// A point's image is (u, v, w): w is its distance from the eye along the view's axis, in units of `unit`; its place in
/// the picture, in samples from the centre, right and down, is (u / w, v / w) in perspective, else (u, v). As that is
/// linear in the point, planes stay planes and handedness is kept.
struct VolumeView {
    int width = 1;
    int height = 1;
    Eigen::Vector2d centre{0.5, 0.5}; ///< of the whole picture, in samples from the upper left corner of what is drawn
    bool perspective = true;
    Eigen::Matrix<double, 3, 4> imageFromWorld = Eigen::Matrix<double, 3, 4>::Zero();
    double unit = 1;                       ///< of w, in the units of the dataset
    double nearest = 0;                    ///< the smallest w that is drawn, in perspective
    Eigen::Vector2d samplesPerSlope{1, 1}; ///< in perspective: how far in the picture one unit of length is at w = 1
    Eigen::Vector3d eye{0, 0, 0};          ///< in orthographic views the direction towards it, of unit length

    /// The place of sample 0 in the picture, from its centre.
    double firstX() const noexcept { return sampleX - centre.x(); }
    double firstY() const noexcept { return sampleY - centre.y(); }
    /// Right, down and away from the eye, of unit length, as rows.
    Eigen::Matrix3f axes() const { return imageFromWorld.leftCols<3>().rowwise().normalized().cast<float>(); }
};

/// The near plane is that of projectionMatrix(); without perspective there is none.
VolumeView makeVolumeView(const Camera& camera, int width, int height, const Eigen::AlignedBox3d& bounds);
/// The same view of a part of the picture.
VolumeView partOf(const VolumeView& whole, const SampleRectangle& part);

} // namespace tetra
