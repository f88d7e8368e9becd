// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/verify/exact_cell.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>

namespace tetra {

/// |value - interpolation| at a place in a positive cell.
struct CellError {
    double error = 0;
    double doubt = 0; ///< how much of it may be rounding
};

/// In double precision; preciseError() leaves no doubt worth speaking of.
CellError quickError(const PlacedCell& cell, const std::array<double, 4>& values, const Eigen::Vector3d& place,
                     double value);
/// With 113 bits.
double preciseError(const PlacedCell& cell, const std::array<double, 4>& values, const Eigen::Vector3d& place,
                    double value);

} // namespace tetra
