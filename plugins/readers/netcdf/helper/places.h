// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/process/findings.h"
#include "plugins/readers/netcdf/helper/fields.h"

#include <array>

namespace tetra {

/// A coordinate of the world at the points of a field.
struct WorldCoordinate {
    const NetCdfVariable* variable = nullptr; ///< null: the number along the one dimension, from 0
    /// Along which of the field's dimensions of space (0 is the slowest) it changes, its slowest first.
    std::vector<std::size_t> along{};
    NetCdfPart part{};            ///< of the variable
    std::vector<double> values{}; ///< one for each point along them
};

/// Where the points of a field lie.
struct FieldPlaces {
    std::array<WorldCoordinate, 3> world; ///< x, y, z
    bool isLattice = false;               ///< each runs along a dimension of its own, in equal steps
    Lattice lattice{.size = {0, 0, 0}};
    std::string lengthUnit{};
    std::vector<std::string> untold{};
    std::vector<Taken> taken{}; ///< Places
    std::vector<Message> remarks{};
    std::vector<Message> leftOut{};
};

/// By the field's coordinate variables (chapters 4 and 5 of the conventions CF): of its dimensions, and those that its
/// attribute "coordinates" names if they run along several of its dimensions, as longitude and latitude of curved
/// grids. Without coordinates, the fastest dimension is x and points are one unit apart. Errors: the library's;
/// a file that holds more coordinates than it can.
Result<FieldPlaces> placesOf(const NetCdfFile& file, const NetCdfField& field, const FieldPart& part);

/// The position of each point of the field, its fastest dimension first.
std::vector<Eigen::Vector3d> positionsOf(const NetCdfFile& file, const NetCdfField& field, const FieldPlaces& places);

/// The coordinate that a variable is for a field; nothing if it has dimensions that the field has not.
std::optional<WorldCoordinate> coordinateFor(const NetCdfFile& file, const NetCdfField& field, const FieldPart& part,
                                             const NetCdfVariable& variable);

} // namespace tetra
