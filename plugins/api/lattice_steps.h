// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>

#include <Eigen/Core>

#include <cmath>

namespace tetra {

/// For readers: the frame of a lattice out of what files say of it. What is along an axis is so exactly, without signs
/// of zeros, so that a lattice along x, y and z is one by Lattice::isAlongAxes(). Whether the result makes sense, with
/// numbers that are not finite, or vectors of no length or in a plane, says checkLatticePlacement().

/// Parts across an axis, of a vector of length 1, that are a rounding: a lattice of 2^32 points stays where it is by a
/// hundredth of a step.
inline constexpr double roundingAcrossAxis = 1e-12;

/// A vector with the zeros that it would have without rounding, and none of them negative.
inline Eigen::Vector3d withoutRounding(const Eigen::Vector3d& vector)
{
    if (!vector.allFinite())
        return vector;
    const double least = roundingAcrossAxis * vector.cwiseAbs().maxCoeff();
    return vector.unaryExpr([least](double part) { return std::abs(part) <= least ? 0.0 : part; });
}

/// A step along i, j or k leads by a column of `steps`.
inline void placeBySteps(Lattice& lattice, const Eigen::Matrix3d& steps, const Eigen::Vector3d& origin)
{
    lattice.origin = origin;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d step = withoutRounding(steps.col(axis));
        const double largest = step.cwiseAbs().maxCoeff();
        const bool isAlongAxis = (step.array() != 0).count() <= 1;
        const double unit = isAlongAxis ? largest : std::ldexp(1.0, std::ilogb(largest)); // squares would overflow
        const Eigen::Vector3d scaled = step / unit;
        const double length = isAlongAxis ? 1 : scaled.norm();
        lattice.spacing[axis] = unit * length;
        lattice.directions.col(axis) = scaled / length;
    }
    lattice.directions.array() += 0.0; // -0 becomes 0
}

/// A step along i, j or k leads by a column of `directions`, which should be of length 1, times its spacing, which may
/// be negative.
inline void placeByDirections(Lattice& lattice, const Eigen::Matrix3d& directions, const Eigen::Vector3d& spacing,
                              const Eigen::Vector3d& origin)
{
    constexpr double roundingOfUnits = 5e-7; // headers hold few digits
    placeBySteps(lattice, directions * spacing.asDiagonal(), origin);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        if (std::abs(directions.col(axis).norm() - 1) <= roundingOfUnits) {
            lattice.spacing[axis] = std::abs(spacing[axis]);
            lattice.directions.col(axis) = withoutRounding(directions.col(axis) * (spacing[axis] < 0 ? -1.0 : 1.0));
        }
    lattice.directions.array() += 0.0;
}

} // namespace tetra
