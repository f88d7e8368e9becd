// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/mesh.h>
#include <tan/transfer.h>

#include <Eigen/Core>

#include <cmath>

namespace tetra::testing {

/// What the tests of a blended focus draw, in the unit cube.

/// A field that is steep enough for two meshes of it to look different.
inline double waves(const Eigen::Vector3d& p)
{
    return 0.5 + 0.3 * std::sin(5 * p.x() + 2 * p.y()) * std::cos(4 * p.z()) + 0.2 * std::sin(6 * p.y() - p.z());
}

/// With a step; the larger the value, the more opaque.
inline TransferFunction rainbow(double opacity)
{
    return transferFunctionFromPoints({{0, {0.1f, 0.1f, 0.9f}, 0},
                                       {0.4, {0.1f, 0.8f, 0.3f}, static_cast<float>(0.3 * opacity)},
                                       {0.4, {0.9f, 0.9f, 0.1f}, static_cast<float>(0.1 * opacity)},
                                       {1, {0.9f, 0.1f, 0.1f}, static_cast<float>(opacity)}},
                                      0.2);
}

inline const Sphere ball{{0.45, 0.5, 0.55}, 0.3};
inline const Box box{{0.2, 0.3, 0.1}, {0.7, 0.8, 0.75}};

} // namespace tetra::testing
