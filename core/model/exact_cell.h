// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/topology.h"

#include <array>
#include <cstdint>

namespace tetra {

/// Lattice coordinates. A lattice has at most 2^32 points, so every determinant below stays under 2^40 and is exact.
using LatticePoint = std::array<std::int64_t, 3>;
using CellCorners = std::array<LatticePoint, 4>;

constexpr LatticePoint difference(const LatticePoint& a, const LatticePoint& b) noexcept
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

constexpr LatticePoint crossProduct(const LatticePoint& a, const LatticePoint& b) noexcept
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

constexpr std::int64_t dotProduct(const LatticePoint& a, const LatticePoint& b) noexcept
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Six times the volume; positive for a positive cell.
constexpr std::int64_t sixVolumes(const CellCorners& c) noexcept
{
    return dotProduct(difference(c[1], c[0]), crossProduct(difference(c[2], c[0]), difference(c[3], c[0])));
}

/// Six volumes times the barycentric coordinates of the points along a row in x: `start` at the row's first point,
/// `step` from one point to the next.
struct BarycentricRow {
    std::array<std::int64_t, 4> start{};
    std::array<std::int64_t, 4> step{};
};

/// The four planes of a cell as integer functions of the place, each zero on one face and sixVolumes() at the corner
/// opposite to it.
class BarycentricPlanes {
public:
    constexpr explicit BarycentricPlanes(const CellCorners& c) noexcept
    {
        for (int corner = 0; corner < 4; ++corner) {
            const auto& [first, second, third] = cornersOfFace[corner];
            const LatticePoint& origin = c[first];
            normals_[corner] = crossProduct(difference(c[third], origin), difference(c[second], origin)); // inwards
            origins_[corner] = origin;
        }
    }

    constexpr BarycentricRow row(const LatticePoint& first) const noexcept
    {
        BarycentricRow row;
        for (int corner = 0; corner < 4; ++corner) {
            row.start[corner] = dotProduct(normals_[corner], difference(first, origins_[corner]));
            row.step[corner] = normals_[corner][0];
        }
        return row;
    }

private:
    std::array<LatticePoint, 4> normals_;
    std::array<LatticePoint, 4> origins_;
};

} // namespace tetra
