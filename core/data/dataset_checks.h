// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <array>
#include <cstdint>
#include <string>

namespace tetra {

/// "32 x 32 x 32".
TAN_INTERNAL std::string sizeText(const std::array<std::uint64_t, 3>& size);

/// How many corners of a grid's cells are positive and negative in physical space: a corner with its three edges, in
/// the order of computational space. The others have no volume.
struct CellCornerSigns {
    std::uint64_t positive = 0;
    std::uint64_t negative = 0;
};

/// For curvilinear datasets; O(points), all threads.
CellCornerSigns cellCornerSigns(const Dataset& dataset);

/// Whether what is positive in the grid's computational space is negative in physical space: more corners of its cells
/// are negative than positive. As cellCornerSigns().
TAN_INTERNAL bool isLeftHanded(const Dataset& dataset);

/// Whether the columns are of unit length, and no one lies in the plane of the others.
bool areDirections(const Eigen::Matrix3d& directions);

/// Whether a float holds each coordinate exactly.
TAN_INTERNAL bool fitFloats(const std::vector<Eigen::Vector3d>& positions);

} // namespace tetra
