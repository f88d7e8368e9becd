// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// The sign of det(b - a, c - a, d - a): 1, 0 or -1. Exact for all doubles whose triple products neither overflow nor
/// underflow: in doubles where a bound on their rounding allows it, else in integers of 128 bits where the points lie
/// close enough together, else as a sum of doubles that rounds nothing (Shewchuk 1997): a tenth of a microsecond where
/// the normal of a, b and c is one of doubles, a microsecond where the differences of the coordinates are, else
/// some 20.
int orientationSign(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c,
                    const std::array<double, 3>& d);

/// The sign of det(b - a, c - a, direction), that of orientationSign() for a point far away in that direction. As exact
/// and as fast.
int directionSign(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c,
                  const std::array<double, 3>& direction);

/// The exact sign of (b-a) . ((c-a) x (d-a)).
inline int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                       const Eigen::Vector3d& d)
{
    return orientationSign({a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {c[0], c[1], c[2]}, {d[0], d[1], d[2]});
}

inline int orientation(std::span<const Eigen::Vector3d> positions, const std::array<std::uint32_t, 4>& tetrahedron)
{
    return orientation(positions[tetrahedron[0]], positions[tetrahedron[1]], positions[tetrahedron[2]],
                       positions[tetrahedron[3]]);
}

/// In doubles.
inline double volumeOf(std::span<const Eigen::Vector3d> positions, const std::array<std::uint32_t, 4>& tetrahedron)
{
    const Eigen::Vector3d& a = positions[tetrahedron[0]];
    return (positions[tetrahedron[1]] - a).dot((positions[tetrahedron[2]] - a).cross(positions[tetrahedron[3]] - a)) /
           6;
}

} // namespace tetra
