// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/hdf5/helper/array_axes.h"

#include <tan/data.h>

namespace tetra {

/// Where the points of an array lie.
struct ArrayPlaces {
    bool isLattice = true;
    Lattice lattice{.size = {0, 0, 0}};               ///< its size also of a grid
    std::array<std::vector<double>, 3> coordinates{}; ///< of a grid: along each of its dimensions, the slowest first
    std::array<std::size_t, 3> world{};               ///< ArrayAxes::world
    std::string space{};                              ///< Dataset::space
    std::string lengthUnit{};
    std::vector<std::string> untold{};
    std::vector<Taken> taken{}; ///< Places
    std::vector<Message> remarks{};
    std::vector<Message> leftOut{};
};

/// By coordinates along the axes (dimension scales, NeXus), which may be uneven; else by the frame of ITK or of
/// Imaris; else by the attributes element_size_um, spacing, voxel_size, resolution and origin, offset of the array or
/// of its group, which are in the order of its dimensions. Errors: too few points, or too many.
Result<ArrayPlaces> placesOf(hid_t file, const Hdf5Array& array, const ArrayAxes& axes);

/// Of a grid: the position of each point, its fastest dimension first.
std::vector<Eigen::Vector3d> positionsOf(const ArrayPlaces& places);

} // namespace tetra
