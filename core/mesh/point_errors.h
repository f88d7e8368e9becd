// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/mesh/lattice_samples.h"
#include "core/mesh/star.h"

#include <cstdint>
#include <span>

namespace tetra {

/// Points sorted by the tetrahedra of a star that contain them: face f has offsets[f] up to offsets[f + 1].
struct PlacedPoints {
    std::span<const PackedPoint> points;
    std::span<const std::uint32_t> offsets;
    std::span<const float> x, y, z; ///< relative to the apex
};

/// Room to work in, used again.
struct PointErrorRoom {
    Buffer<double> values;
    Buffer<double> rimValues;
};

/// scaledErrors[i] / divisors[face] = the weighted distance of the sample of point i from the interpolation in the
/// tetrahedron that it is in. The quotient does not depend on which of several tetrahedra that hold a point it is
/// computed in, bit for bit, if the point is on the box's boundary: so boxes agree about shared points (S3). For
/// samples of up to 16 bits that is so for all points, because numerator and divisor are exact integers (S8).
void computeErrors(const PackedLattice& lattice, const LatticeSamples& samples, const Star& star,
                   const PlacedPoints& placed, PointErrorRoom& room, std::span<double> scaledErrors,
                   std::span<double> divisors);

struct PlacedError {
    PackedPoint point = 0;
    float error = 0;
};

/// The largest error, rounded up to a float, and the first point of the lattice that has it *after rounding*: the queue
/// orders points in the same way. There must be a point.
PlacedError worstError(std::span<const PackedPoint> points, std::span<const double> scaledErrors, double divisor);

} // namespace tetra
