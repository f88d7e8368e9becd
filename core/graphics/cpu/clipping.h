// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace tetra {

/// A corner before the division by w.
struct ClipVertex {
    Eigen::Vector4d position{0, 0, 0, 1};
    Eigen::Vector3f normal{0, 0, 1};
    Eigen::Vector3f colour{0, 0, 0}; ///< red, green, blue; where vertices have colours
};

/// How far beyond the picture's edge a corner may lie, in units of half the picture, before its triangle is cut: far
/// enough that few are, near enough for 32-bit coordinates.
inline constexpr double guardBand = 3;

/// On which sides of the view a corner lies outside, as bits.
namespace outside {
inline constexpr std::uint8_t left = 1;
inline constexpr std::uint8_t right = 2;
inline constexpr std::uint8_t below = 4;
inline constexpr std::uint8_t above = 8;
inline constexpr std::uint8_t near = 16;
inline constexpr std::uint8_t guard = 32;
inline constexpr std::uint8_t notFinite = 64;
/// Sides such that a triangle wholly beyond one of them is invisible.
inline constexpr std::uint8_t view = left | right | below | above | near;
/// What calls for cutting.
inline constexpr std::uint8_t cut = near | guard;
} // namespace outside

std::uint8_t outsideBits(const Eigen::Vector4d& position) noexcept;

/// A convex polygon with as many corners as a triangle can get from five cuts.
struct ClippedPolygon {
    std::array<ClipVertex, 8> corners;
    std::size_t count = 0;
};

/// The part of a triangle behind the near plane and inside the guard band. Triangles that share an edge get the same
/// new corners on it, bit for bit.
ClippedPolygon clipTriangle(const std::array<ClipVertex, 3>& triangle);

} // namespace tetra
