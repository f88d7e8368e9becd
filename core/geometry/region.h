// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <variant>

namespace tetra {

/// Regions of space, closed and convex; lengths are those of the dataset.
struct Sphere {
    Eigen::Vector3d centre{0, 0, 0};
    double radius = 0; ///< 0 is a point: distance to a camera
    bool operator==(const Sphere&) const = default;
};
/// What lies on the side that `normal`, a unit vector, points away from: normal . x <= offset.
struct HalfSpace {
    Eigen::Vector3d normal{0, 0, 1};
    double offset = 0;
    bool operator==(const HalfSpace&) const = default;
};
struct Box {
    Eigen::Vector3d least{0, 0, 0};
    Eigen::Vector3d largest{0, 0, 0};
    bool operator==(const Box&) const = default;
};
using Region = std::variant<Box, Sphere, HalfSpace>;

} // namespace tetra
