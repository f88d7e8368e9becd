// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/box_tree.h"
#include "core/refine/curvilinear/curvilinear_grid.h"
#include "core/refine/lattice/lattice_delaunay.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The error of a mesh of a curvilinear grid where the grid's points lie in space (C12, R5): of the tetrahedra there
/// the one that comes closest counts, outside of all the nearest place on the boundary. For refinement that is to keep
/// it; tan/verify.h has a measure of its own. Some 50 bytes a point.
class SpaceErrors {
public:
    /// `extent`: of the values. The grid outlives it. O(n log^2 n).
    SpaceErrors(const CurvilinearGrid& grid, double extent);

    /// The worst point of a tetrahedron, or of a face on the boundary, which belongs to its tetrahedron.
    struct Worst {
        std::uint32_t point = 0;
        float error = 0; ///< a bound, weighted (R6)
        std::uint32_t slot = 0;
    };
    /// Of the tetrahedra of a whole grid (LatticeDelaunay::tetrahedra(), dead ones among them) a bound on the error at
    /// all points; to `found` it gives the worst of each tetrahedron that is worse than `limit`, the worst first. On
    /// all threads, the same with any number of them; O(tetrahedra + points) times the depth of the tree.
    float measure(std::span<const DelaunayTetrahedron> tetrahedra, double limit, std::vector<Worst>& found);

private:
    struct Boundary;

    void measureIn(const DelaunayTetrahedron& tetrahedron, std::uint32_t slot);
    void measureOutside(std::span<const DelaunayTetrahedron> tetrahedra);
    void note(std::uint32_t point, double error, std::uint32_t slot);

    const CurvilinearGrid& grid_;
    double extent_;
    BoxTree tree_;                                     ///< of the points
    std::vector<std::atomic<std::uint64_t>> measured_; ///< of each point the bits of the least bound, then the slot
};

} // namespace tetra
