// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace tetra {

/// What mergePoints() did.
struct MergedPoints {
    std::uint64_t removed = 0;     ///< points that lay where an earlier one lies
    std::uint64_t conflicting = 0; ///< places whose points had different values
};

/// Leaves one point on each place, the first there, with the mean of the values there: a mesh has one value at a vertex
/// (S20). The others keep their order. O(n log n).
MergedPoints mergePoints(std::vector<Eigen::Vector3d>& positions, std::vector<double>& values);

/// What was done, in a sentence for the user; empty if nothing was.
Message mergeRemark(const MergedPoints& merged);

} // namespace tetra
