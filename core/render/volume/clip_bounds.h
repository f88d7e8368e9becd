// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/volume/volume_view.h"

#include <tan/render.h>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace tetra {

/// The clip planes of a scene in a view: what they leave of the ray through a sample.
class ClipBounds {
public:
    /// Of q (ViewTransform): shown is what is not nearer than `front` and not farther than `back`; nothing if front is
    /// less than back.
    struct Interval {
        float front;
        float back;
    };

    ClipBounds() = default;
    ClipBounds(std::span<const ClipPlane> planes, const VolumeView& view);

    bool empty() const noexcept { return planes_.empty(); }
    Interval at(int column, int row) const noexcept;

private:
    /// Shown is what has perColumn * column + perRow * row + atOrigin >= perNearness * q.
    struct ScreenPlane {
        double perColumn, perRow, atOrigin, perNearness;
    };
    std::vector<ScreenPlane> planes_;
};

} // namespace tetra
