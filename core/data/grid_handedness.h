// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset.h"

namespace tetra {

/// Whether what is positive in the grid's computational space is negative in physical space: most of the corners of its
/// cells, each with its three edges, are. For curvilinear datasets; O(points), all threads.
bool isLeftHanded(const Dataset& dataset);

/// Whether a float holds each coordinate exactly.
bool fitFloats(const std::vector<Eigen::Vector3d>& positions);

} // namespace tetra
