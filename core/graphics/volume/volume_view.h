// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/camera.h"

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
    bool perspective = true;
    Eigen::Matrix<double, 3, 4> imageFromWorld = Eigen::Matrix<double, 3, 4>::Zero();
    double unit = 1;                       ///< of w, in the units of the dataset
    double nearest = 0;                    ///< the smallest w that is drawn, in perspective
    Eigen::Vector2d samplesPerSlope{1, 1}; ///< in perspective: how far in the picture one unit of length is at w = 1
    Eigen::Vector3d eye{0, 0, 0};          ///< in orthographic views the direction towards it, of unit length

    /// The place of sample 0 in the picture, from its centre. Samples are not quite in the middle of the pixels, so
    /// that the corners and faces of lattices, which views along an axis would put there, do not fall on them.
    double firstX() const noexcept { return 0.5 + 0.00137 - width / 2.0; }
    double firstY() const noexcept { return 0.5 + 0.00211 - height / 2.0; }
};

/// The near plane is that of projectionMatrix(); without perspective there is none.
VolumeView makeVolumeView(const Camera& camera, int width, int height, const Eigen::AlignedBox3d& bounds);

} // namespace tetra
