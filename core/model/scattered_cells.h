// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/level_cells.h"

#include <Eigen/Core>

#include <array>
#include <span>
#include <string>

namespace tetra {

/// The corners of a cell, by position.
using PlacedCell = std::array<Eigen::Vector3d, 4>;

/// `points` of the cell's corners.
PlacedCell placedCell(std::span<const Eigen::Vector3d> positions, const std::array<std::uint32_t, 4>& points);
/// A cell of a mesh.
inline PlacedCell placedCell(std::span<const Eigen::Vector3d> positions, const LevelCells& cells, std::size_t number)
{
    const LevelCells::Cell& c = cells.vertices(number);
    return placedCell(positions, {cells.point(c[0]), cells.point(c[1]), cells.point(c[2]), cells.point(c[3])});
}

/// Exact signs of a cell's volume, and of whether a place lies in a positive cell, its boundary included or not.
int volumeSign(const PlacedCell& cell);
bool holds(const PlacedCell& cell, const Eigen::Vector3d& place);
bool holdsInside(const PlacedCell& cell, const Eigen::Vector3d& place);

/// |value - interpolation| at a place in a positive cell.
struct CellError {
    double error = 0;
    double doubt = 0; ///< how much of it may be rounding
};
/// In double precision, and with 113 bits and no doubt worth speaking of.
CellError quickError(const PlacedCell& cell, const std::array<double, 4>& values, const Eigen::Vector3d& place,
                     double value);
double preciseError(const PlacedCell& cell, const std::array<double, 4>& values, const Eigen::Vector3d& place,
                    double value);

/// For messages: "(1.5, -2, 0.25)".
std::string textOf(const Eigen::Vector3d& place);
std::string textOf(const PlacedCell& cell);

} // namespace tetra
