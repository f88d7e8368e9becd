// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/tetrahedron_planes.h"

#include "core/mesh/topology.h"

#include <algorithm>
#include <cmath>

namespace tetra {

TetrahedronPlanes::TetrahedronPlanes(const std::array<Eigen::Vector3d, 4>& corners)
{
    for (std::size_t face = 0; face < 4; ++face) {
        const auto& [first, second, third] = cornersOfFace[face];
        const Eigen::Vector3d& origin = corners[first];
        const Eigen::Vector3d a = corners[third] - origin; // inwards
        const Eigen::Vector3d b = corners[second] - origin;
        origins_[face] = origin;
        normals_[face] = a.cross(b);
        const Eigen::Vector3d p = a.cwiseAbs(), q = b.cwiseAbs();
        magnitudes_[face] = {p[1] * q[2] + p[2] * q[1], p[2] * q[0] + p[0] * q[2], p[0] * q[1] + p[1] * q[0]};
        box_.extend(corners[face]);
    }
}

bool TetrahedronPlanes::mayMeet(const Eigen::AlignedBox3d& box) const
{
    constexpr double margin = 32 * 0x1p-53;
    if (!box_.intersects(box))
        return false;
    for (std::size_t face = 0; face < 4; ++face) {
        double farthest = 0;
        double doubt = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double low = box.min()[axis] - origins_[face][axis];
            const double high = box.max()[axis] - origins_[face][axis];
            farthest += std::max(normals_[face][axis] * low, normals_[face][axis] * high);
            doubt += magnitudes_[face][axis] * std::max(std::abs(low), std::abs(high));
        }
        if (farthest < -margin * doubt)
            return false;
    }
    return true;
}

} // namespace tetra
