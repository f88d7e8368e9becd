// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/camera.h"

namespace tetra {

/// From where, into how many samples, and what box near and far enclose.
struct SampleView {
    Camera camera;
    int width = 1;
    int height = 1;
    Eigen::AlignedBox3d bounds;
    bool amongRays = false; ///< samples lie where the CPU back end has the rays of a volume, else in the middle
};

} // namespace tetra
