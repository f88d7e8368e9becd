// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/render_backend.h"

namespace tetra {

/// What there is to draw in a picture.
struct FrameWork {
    double tetrahedra = 0; ///< of the volume
    double triangles = 0;  ///< of the surfaces
    double samples = 0;    ///< of the picture
};

/// The time of a picture as a sum of four parts (R23), each a shape that is known beforehand times a factor that is
/// learnt from pictures: order and set-up go with the tetrahedra, filling with the tetrahedra and the fragments, the
/// rest with triangles and samples. A ray crosses about as many tetrahedra as the cube root of their number tells.
struct FrameCost {
    double order = 1;
    double setUp = 1;
    double fill = 1;
    double rest = 1;
    double fragmentsPerCrossing = 0.7; ///< fragments / (samples * cube root of the tetrahedra)
    bool operator==(const FrameCost&) const = default;
};

/// In seconds; with a new visibility order, whether or not an old one will do.
double predictedSeconds(const FrameCost& cost, const FrameWork& work);

/// After a picture that took `seconds`: halfway to what it says, so that one picture that was held up does not count
/// much. Of a back end that tells nothing but the time, all parts change alike.
FrameCost learned(const FrameCost& cost, const FrameWork& work, const RenderStatistics& statistics, double seconds);

} // namespace tetra
