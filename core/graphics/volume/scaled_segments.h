// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_segments.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// A segment of the transfer function for the kernels: in single precision, over scaled values, from the segment's
/// origin. Lengths are those of w (VolumeView).
struct ScaledSegment {
    float begin = 0; ///< scaled values; finite, but beyond all values at the ends
    float end = 0;
    float origin = 0;
    float halfExtinction = 0; ///< at the origin, like the colour
    float halfExtinctionPerValue = 0;
    float colour[3] = {};
    float colourPerValue[3] = {};
    float largestExtinction = 0;
    bool transparent = true;
};

/// The segments of a function over values that are scaled so that its knots lie in [0, 1].
struct ScaledSegments {
    std::vector<ScaledSegment> segments;
    std::vector<double> knots; ///< where segments meet, unscaled
    double smallest = 0;       ///< (value - smallest) * perValue is the scaled value
    double perValue = 1;
};

/// `unit`: the length of w = 1 (VolumeView), in the units of the dataset.
ScaledSegments scaleSegments(std::span<const TransferSegment> segments, double unit);

} // namespace tetra
