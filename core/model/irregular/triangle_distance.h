// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>

namespace tetra {

/// The corners of a triangle.
using TriangleCorners = std::array<Eigen::Vector3d, 3>;

/// A place of a triangle, as weights of its corners, and how far it is.
struct TrianglePlace {
    std::array<double, 3> weights{};
    double distance = 0;
};

/// The place next to `from`, in doubles.
TrianglePlace nearestPlace(const TriangleCorners& triangle, const Eigen::Vector3d& from);

/// Least and largest of the linear function with these values at the corners among the places at most `radius` from
/// `centre`, in doubles; none if there is no such place.
std::optional<std::array<double, 2>> valuesWithin(const TriangleCorners& triangle, const std::array<double, 3>& values,
                                                  const Eigen::Vector3d& centre, double radius);

} // namespace tetra
