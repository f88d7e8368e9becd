// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>

namespace tetra {

/// A tetrahedron that interpolates linearly.
struct InterpolatingCell {
    std::array<Eigen::Vector3d, 4> corners;
    std::array<double, 4> values;
};

/// |value - interpolation| at a position that lies in the cell, however thin the cell is: right to 1e-13 of the largest
/// difference between `value` and the cell's values. What rounding alone would explain is 0.
double interpolationError(const InterpolatingCell& cell, const Eigen::Vector3d& position, double value);

} // namespace tetra
