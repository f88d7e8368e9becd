// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/order_drift.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetra {
namespace {

using Eigen::Vector3d;

double degreesBetween(const Vector3d& a, const Vector3d& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

Vector3d towardsEye(const Camera& camera)
{
    return viewMatrix(camera).block<1, 3>(2, 0).transpose();
}

} // namespace

double orderDrift(const Eigen::AlignedBox3d& bounds, const Camera& from, const Camera& to)
{
    if (from.perspective != to.perspective)
        return 180;
    if (!from.perspective)
        return degreesBetween(towardsEye(from), towardsEye(to));
    const Vector3d before = eyePosition(from), after = eyePosition(to);
    if (bounds.isEmpty() || before == after)
        return 0;
    if (bounds.contains(before) || bounds.contains(after))
        return 180;
    double drift = degreesBetween(before - bounds.center(), after - bounds.center());
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3d place = bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
        drift = std::max(drift, degreesBetween(before - place, after - place));
    }
    return drift;
}

} // namespace tetra
