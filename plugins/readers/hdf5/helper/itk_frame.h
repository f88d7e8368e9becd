// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/hdf5/helper/array_axes.h"

#include <Eigen/Core>

#include <optional>

namespace tetra {

/// Where an image lies that ITK wrote: in the group of the array "VoxelData" the arrays "Origin" and "Spacing" along
/// x, y, z, and "Directions", a row for each axis.
struct ItkFrame {
    Eigen::Vector3d origin;
    Eigen::Vector3d spacing;
    Eigen::Matrix3d directions; ///< of i, j, k as columns
};

/// Nothing if the array is none of ITK's, or not of three dimensions.
std::optional<ItkFrame> itkFrameOf(hid_t file, const Hdf5Array& array, const ArrayAxes& axes);

} // namespace tetra
