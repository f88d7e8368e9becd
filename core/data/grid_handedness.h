// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset.h"

namespace tetra {

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
bool isLeftHanded(const Dataset& dataset);

/// Whether a float holds each coordinate exactly.
bool fitFloats(const std::vector<Eigen::Vector3d>& positions);

} // namespace tetra
