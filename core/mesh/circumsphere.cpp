// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/circumsphere.h"

#include <algorithm>

namespace tetra {

namespace {

/// The integer nearest to a / b, of two the smaller; b is positive.
std::int64_t nearestQuotient(std::int64_t a, std::int64_t b)
{
    // The quotient less a half, rounded up.
    const std::int64_t numerator = 2 * a - b, denominator = 2 * b;
    const std::int64_t towardsZero = numerator / denominator;
    return towardsZero + (numerator % denominator > 0 ? 1 : 0);
}

} // namespace

std::optional<PackedPoint> deepestPointInSphere(const PackedLattice& lattice, const DelaunayTetrahedron& tetrahedron,
                                                const LatticeBox& box)
{
    const PackedPoint apex = tetrahedron.vertices[0];
    const std::array<std::int32_t, 3> origin{lattice.x(apex), lattice.y(apex), lattice.z(apex)};
    const std::array<double, 4>& sphere = tetrahedron.sphere;
    // The distance to the centre is a sum over the axes, and the box is one of intervals: each axis by itself.
    std::array<std::uint32_t, 3> nearest{};
    double power = 0; // times the determinant; positive inside
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t offset =
            nearestQuotient(static_cast<std::int64_t>(sphere[axis]), 2 * static_cast<std::int64_t>(sphere[3]));
        const std::int64_t coordinate =
            std::clamp<std::int64_t>(origin[axis] + offset, box.origin[axis], box.last(axis));
        nearest[axis] = static_cast<std::uint32_t>(coordinate);
        const double q = static_cast<double>(coordinate - origin[axis]);
        power += sphere[axis] * q - sphere[3] * q * q;
    }
    if (power <= 0)
        return std::nullopt;
    return lattice.pack(nearest[0], nearest[1], nearest[2]);
}

} // namespace tetra
