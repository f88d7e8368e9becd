// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/tetrahedron_overlap.h"

#include "core/geometry/orientation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>

namespace tetra {

namespace {

using CornerPlaces = std::array<Eigen::Vector3d, 4>;

/// On which sides of a plane corners lie.
struct PlaneSides {
    bool front = false;
    bool back = false;

    void add(int sign)
    {
        front = front || sign > 0;
        back = back || sign < 0;
    }
    bool both() const { return front && back; }
};

/// Whether the plane through three points has one tetrahedron on either side, or in it.
bool separatesThem(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                   const CornerPlaces& one, const CornerPlaces& other)
{
    PlaneSides ofOne, ofOther;
    for (const Eigen::Vector3d& corner : one) {
        ofOne.add(orientation(a, b, c, corner));
        if (ofOne.both())
            return false;
    }
    for (const Eigen::Vector3d& corner : other) {
        ofOther.add(orientation(a, b, c, corner));
        if (ofOther.both() || (ofOne.front && ofOther.front) || (ofOne.back && ofOther.back))
            return false;
    }
    return ofOne.front || ofOne.back; // else the three are on a line: no tetrahedron lies in a plane
}

} // namespace

/// If two convex bodies have no volume in common, there is a plane between them that goes through three of their
/// corners which are not on a line: of the planes between them, which make up a pointed cone, an extreme one.
bool tetrahedraOverlap(std::span<const Eigen::Vector3d> positions, const std::array<std::uint32_t, 4>& one,
                       const std::array<std::uint32_t, 4>& other)
{
    std::array<CornerPlaces, 2> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        corners[0][i] = positions[one[i]];
        corners[1][i] = positions[other[i]];
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto along = [axis](const Eigen::Vector3d& corner) { return corner[axis]; };
        const auto [low, high] = std::ranges::minmax(corners[0], {}, along);
        const auto [otherLow, otherHigh] = std::ranges::minmax(corners[1], {}, along);
        if (high[axis] <= otherLow[axis] || otherHigh[axis] <= low[axis])
            return false;
    }
    const auto separated = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
        return separatesThem(a, b, c, corners[0], corners[1]);
    };
    for (const CornerPlaces& t : corners) // most are separated by a face
        for (std::size_t out = 0; out < 4; ++out)
            if (separated(t[(out + 1) % 4], t[(out + 2) % 4], t[(out + 3) % 4]))
                return false;
    for (std::size_t which = 0; which < 2; ++which)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j)
                for (const Eigen::Vector3d& point : corners[1 - which])
                    if (separated(corners[which][i], corners[which][j], point))
                        return false;
    return true;
}

} // namespace tetra
