// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/clip_bounds.h"

#include "core/render/volume/cell_setup.h"

#include <Eigen/LU>

#include <algorithm>

namespace tetra {

ClipBounds::ClipBounds(std::span<const ClipPlane> planes, const VolumeView& view)
{
    const Eigen::Matrix3d worldFromImage = view.imageFromWorld.leftCols<3>().inverse();
    for (const ClipPlane& plane : planes) {
        // normal . x >= offset, of the image: image . (u, v, w) >= there.
        const Eigen::Vector3d image = worldFromImage.transpose() * plane.normal;
        const double there = plane.offset + image.dot(view.imageFromWorld.col(3));
        const double atFirst = image.x() * view.firstX() + image.y() * view.firstY();
        if (view.perspective)
            planes_.push_back({image.x(), image.y(), atFirst + image.z(), there});
        else
            planes_.push_back({image.x(), image.y(), atFirst - there, image.z()});
    }
}

ClipBounds::Interval ClipBounds::at(int column, int row) const noexcept
{
    double front = farBound, back = -farBound;
    for (const ScreenPlane& plane : planes_) {
        const double value = plane.perColumn * column + plane.perRow * row + plane.atOrigin;
        if (plane.perNearness > 0)
            front = std::min(front, value / plane.perNearness);
        else if (plane.perNearness < 0)
            back = std::max(back, value / plane.perNearness);
        else if (!(value >= 0))
            front = -farBound;
    }
    const auto bounded = [](double q) { return static_cast<float>(std::clamp<double>(q, -farBound, farBound)); };
    return {bounded(front), bounded(back)};
}

} // namespace tetra
