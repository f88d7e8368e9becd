// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/curvilinear/curvilinear_mesh.h"
#include "core/refine/lattice/lattice_samples.h"

#include <tan/base.h>
#include <tan/build.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

struct CurvilinearRefinementOptions {
    /// Units of the values for a unit of length, more than 0: the key of a mesh is the larger of its error and this
    /// times its warping (S4).
    double warpingWeight = 1;
    double stopKey = 0;        ///< stop at the first consistent mesh with no larger key
    double valueExtent = 1;    ///< largest minus smallest value; only the speed depends on it
    double positionExtent = 1; ///< the diagonal of the positions' bounding box; likewise
    CurvilinearSelection selection = CurvilinearSelection::Normalised;
    std::uint32_t blockEdge = 0; ///< cells along an edge of a block, or 0 for no blocks
};

struct CurvilinearRefinementResult {
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0; ///< all that ever lived
    float finalKey = 0;
    std::uint64_t inverted = 0;   ///< tetrahedra of the last mesh that stay flipped, as the grid itself is there (S5)
    std::uint64_t degenerate = 0; ///< tetrahedra of the last mesh without volume (S6)
};

/// Greedy refinement of a curvilinear grid in computational space (3.1, R8, R9): starting from the eight corners,
/// inserts the point of the largest key until no point's key exceeds the stop. Before that flipped tetrahedra are
/// cured, each by the deepest point in its circumsphere; the worst point inside would do only where there is one, and
/// needs more sites. So every mesh with a finite key is consistent: all that is flipped in it meets a cell that the
/// grid itself has folded, or is made of corners of one cell (CurvilinearGrid::allowsInverted(), S5).
///
/// With the paper's selection the mesh's warping against its error, both in their own units, decides whether the point
/// of the largest warping or of the largest error comes next.
///
/// Blocks are coupled: all are in memory and refined in one order, and a point on a shared face enters all that have
/// it at once, so that the faces are the same at every accuracy (S4). Memory is that of the whole grid. The
/// tetrahedrization is Delaunay in each block; small blocks keep stars small and memory near.
///
/// Ties go to the first point of the grid, so the history depends on nothing but the data. The history goes to `sink`
/// while it is made, then sink.finish(). One thread; about 600 bytes a point. Errors: too large a grid, refused memory,
/// the sink's, cancelled.
///
/// `size`: points along each axis of the grid, at least two. `positions`: where they lie, one a point, all finite.
/// `samples`: their values, with weights that multiply errors and warpings or without (R6).
Result<CurvilinearRefinementResult> refineCurvilinear(const std::array<std::uint32_t, 3>& size,
                                                      std::span<const Eigen::Vector3d> positions,
                                                      const LatticeSamples& samples,
                                                      const CurvilinearRefinementOptions& options, HistorySink& sink,
                                                      const Progress& progress = {});

} // namespace tetra
