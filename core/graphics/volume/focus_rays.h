// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/scene.h"
#include "core/graphics/volume/volume_view.h"

#include <Eigen/Core>

#include <array>
#include <utility>

namespace tetra {

/// The weights of a focus along the rays of a tile, in plain numbers: a place along the ray through a sample, from the
/// region's centre, is start + w * direction, and both are affine in the sample's column and row in the tile.
struct FocusWeights {
    struct Affine {
        std::array<float, 3> origin, perColumn, perRow;
    };
    Affine start, direction;
    std::array<float, 3> halfSize{0, 0, 0}; ///< of a box
    float radius = 0;                       ///< of a ball
    float perBorder = 0;                    ///< 1 / border, very large if that is 0
};

/// The rays of a view through a focus (FocusVolume). Places along a ray are w (VolumeView).
class FocusRays {
public:
    /// enter <= in <= out <= leave. Between `in` and `out` the weight of the fine volume is 1; before `enter` and
    /// after `leave` it is 0. A ray that stays out of the region but not out of its border has in == out.
    struct Passage {
        double enter, in, out, leave;
        bool meets() const noexcept { return enter < leave; } ///< else the ray stays out of both
    };

    FocusRays(const FocusVolume& focus, const VolumeView& view);

    Passage at(int column, int row) const;
    /// Of the fine volume. Columns and rows count from the given ones.
    FocusWeights weightsFrom(int column, int row) const;
    /// A place in the units of the dataset lies in the region.
    bool holds(const Eigen::Vector3f& place) const;

private:
    struct Ray {
        Eigen::Vector3d start, direction; ///< from the region's centre; of w
    };
    Ray rayOf(int column, int row) const;
    /// Where the ray is in the region grown by `margin`, or in something somewhat larger; empty if last <= first.
    std::pair<double, double> within(const Ray& ray, double margin) const;

    std::variant<Box, Sphere> region_;
    double border_;
    bool perspective_;
    double nearest_; ///< w
    double firstX_, firstY_;
    Eigen::Vector3d centre_;
    Eigen::Vector3d halfSize_{0, 0, 0}; ///< of a box
    double radius_ = 0;                 ///< of a ball
    Eigen::Vector3d origin_;            ///< what has the image (0, 0, 0), from the centre
    Eigen::Matrix3d worldFromImage_;
};

} // namespace tetra
