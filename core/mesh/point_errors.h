// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/mesh/lattice_samples.h"
#include "core/mesh/star.h"

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// Points in the tetrahedra of a star. All arrays are equally long, a multiple of four.
struct OwnedPoints {
    std::span<const PackedPoint> points;
    std::span<const std::int32_t> owners; ///< the star's tetrahedron that has the point
    std::span<const float> x, y, z;       ///< relative to the apex
};

/// Room to work in, used again.
struct PointErrorRoom {
    Buffer<double> values;
    Buffer<double> rimValues;
    Buffer<std::array<double, 4>> planes;
};

/// errors[i] = the weighted distance of the sample of point i from the interpolation in the tetrahedron that has it. It
/// does not depend, bit for bit, on which of several tetrahedra that hold a point has it, if the point is on the box's
/// boundary: so boxes agree about shared points (S3). For samples of up to 16 bits that is so for all points, because
/// it is one division of exact integers (S8).
void computeErrors(const PackedLattice& lattice, const LatticeSamples& samples, const Star& star,
                   const OwnedPoints& owned, PointErrorRoom& room, std::span<double> errors);

} // namespace tetra
