// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/history.h"
#include "core/mesh/lattice_samples.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace tetra {

struct LatticeRefinementOptions {
    std::array<std::uint32_t, 3> size{2, 2, 2}; ///< points along each axis, at least two
    Eigen::Vector3d spacing{1, 1, 1};           ///< the Delaunay criterion holds in physical space
    double valueExtent = 1;                     ///< largest minus smallest value; only the speed depends on it
    double stopError = 0;                       ///< stop at the first mesh with no larger error, in units of the values
};

struct LatticeRefinementResult {
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0; ///< all that ever lived
    float finalError = 0;
};

/// Greedy refinement of a regular lattice (3.1, R8): starting from the eight corners, inserts the point of the largest
/// error until no point's error exceeds the stop. Ties go to the first point of the lattice, so the history depends on
/// nothing but the data. The history goes to `sink` while it is made, then sink.finish(). One thread; about 500 bytes a
/// site. Errors: too large a lattice, refused memory, the sink's, cancelled.
Result<LatticeRefinementResult> refineLattice(const LatticeRefinementOptions& options, const LatticeSamples& samples,
                                              HistorySink& sink, const Progress& progress = {});

} // namespace tetra
