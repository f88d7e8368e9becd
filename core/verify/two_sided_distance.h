// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/verify/irregular_original.h"

#include <Eigen/Core>

#include <span>

namespace tetra {

/// How far a mesh's boundary goes from the original's.
struct BoundaryDistances {
    double found = 0; ///< the farthest place that was looked at
    double bound = 0; ///< no place is farther
};

/// From all places of `triangles`, by the points of the original, to the original's boundary. Triangles are cut until
/// what the bound says is at most a twentieth more than what was found, or a thousandth of the diagonal, or the pieces
/// are very small. The same with any number of threads.
BoundaryDistances distancesToOriginal(const IrregularOriginal& original, std::span<const PointTriangle> triangles);

} // namespace tetra
