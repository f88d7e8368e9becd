// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>

namespace tetra {

/// Lattice coordinates. A lattice has at most 2^32 points, so every determinant below stays under 2^40 and is exact.
using LatticePoint = std::array<std::int64_t, 3>;
using LatticeCorners = std::array<LatticePoint, 4>;

constexpr LatticePoint difference(const LatticePoint& a, const LatticePoint& b) noexcept
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

constexpr LatticePoint crossProduct(const LatticePoint& a, const LatticePoint& b) noexcept
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

constexpr std::int64_t dotProduct(const LatticePoint& a, const LatticePoint& b) noexcept
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Six times the volume; positive for a positive cell.
constexpr std::int64_t sixVolumes(const LatticeCorners& c) noexcept
{
    return dotProduct(difference(c[1], c[0]), crossProduct(difference(c[2], c[0]), difference(c[3], c[0])));
}

/// The corners of a cell in physical space.
using PlacedCell = std::array<Eigen::Vector3d, 4>;

/// The sign of the volume of a tetrahedron, det(b - a, c - a, d - a): 1, 0 or -1, exact for all finite doubles, by
/// CGAL's kernel. For verification: shares nothing with what builds.
int volumeSign(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d);
int volumeSign(const PlacedCell& cell);
/// Whether a place lies in a positive cell, its boundary included or not; exact.
bool holds(const PlacedCell& cell, const Eigen::Vector3d& place);
bool holdsInside(const PlacedCell& cell, const Eigen::Vector3d& place);

/// For messages: the shortest form, independent of the locale; "(3, 0, 17)"; "(1.5, -2, 0.25)"; corners with blanks
/// between them.
std::string textOf(double number);
std::string textOf(const LatticePoint& point);
std::string textOf(const Eigen::Vector3d& place);
template <class Corner> std::string textOf(const std::array<Corner, 4>& corners)
{
    return textOf(corners[0]) + " " + textOf(corners[1]) + " " + textOf(corners[2]) + " " + textOf(corners[3]);
}

} // namespace tetra
