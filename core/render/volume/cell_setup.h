// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/volume/projected_vertices.h"

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// a x + b y + c; x and y in samples from a tile's first.
struct alignas(16) AffineFunction {
    float a, b, c;
    float more; ///< what a user of it keeps with it
};

/// The largest optical depth that a ray through a cell may have.
enum class Thickness : std::uint8_t {
    Faint, ///< up to faintDepth
    Thin,  ///< up to 1
    Thick,
};

/// How the value changes along the rays through a cell, away from the eye.
enum class Direction : std::uint8_t {
    Rising,
    Falling,
    Mixed, ///< one or the other from ray to ray
};

/// The field's gradient in a cell whose light changes along the rays, between those at its corners. Each component is a
/// function like the value of CellSetup: components[i] is slope(x, y) / q + constant in perspective, else slope(x, y) +
/// constant * q. The components are those right, down and away from the eye (VertexGradient).
struct CellLight {
    AffineFunction components[3]; ///< the slopes, with the constant as the fourth number
};

/// A cell made ready to be drawn in a tile.
///
/// With q = 1 / w in perspective, else -w, each face's plane is affine in the tile: q = bound(x, y). A ray is inside
/// the cell for q between the largest bound of the faces that it leaves by and the smallest of those it enters by.
/// The value along the ray is slope(x, y) / q + constant in perspective, else slope(x, y) + constant * q.
struct CellSetup {
    /// 0 to 2: bounds of the faces seen from outside, the fronts; 3 to 5: of the others, the backs; those that are not
    /// needed are last and do not bind. 6: the slope.
    AffineFunction functions[7];
    float constant;
    float smallest, largest; ///< values
    float perGradient;       ///< 1 / length of the gradient, if wanted; 0 without one
    const CellLight* light;  ///< null if the cell is not lit
    std::uint16_t firstSegment, lastSegment;
    std::uint8_t left, top, right, bottom; ///< blocks of the tile
    Thickness thickness;
    Direction direction;
    bool simple; ///< in one segment, from whose origin values count; else from 0
    bool flat;   ///< to be left out
    bool around; ///< the eye is inside: all its faces are backs, the fourth of them in functions[0]
};

/// All that cells are set up from.
struct SetupSource {
    std::span<const std::array<std::uint32_t, 4>> tetrahedra;
    std::span<const ProjectedVertex> vertices;
    std::span<const CellClass> classes;
    std::span<const ScaledSegment> segments;
    bool perspective = true;
    std::span<const VertexGradient> gradients{}; ///< of the vertices if cells are lit, else none
    float perFullGradient = 0;                   ///< of volume_mesh.h, of these gradients
    bool measured = false;                       ///< CellSetup::perGradient is wanted
    /// How long u and v are for one unit of length across the view, in units of w for one along it.
    std::array<float, 2> lengths{1, 1};
};

/// A tile's first sample, from the centre of the picture, and the longest way along a ray for one unit of w.
struct TileFrame {
    float x = 0;
    float y = 0;
    float longestRay = 1;
};

/// Larger than any |q|.
inline constexpr float farBound = 1e30f;

/// Asks the memory for what setUpCells() will read: for the cells themselves, and when those are there, for their
/// corners.
void fetchCells(const SetupSource& source, std::span<const BinnedCell> cells);
void fetchCorners(const SetupSource& source, std::span<const BinnedCell> cells);

/// Sets up `cells` into as many `setups`, which refer to as many `lights` if the source has gradients.
void setUpCells(const SetupSource& source, const TileFrame& frame, std::span<const BinnedCell> cells,
                std::span<CellSetup> setups, std::span<CellLight> lights);

} // namespace tetra
