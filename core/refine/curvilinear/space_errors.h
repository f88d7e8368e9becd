// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.h"
#include "core/geometry/box_tree.h"
#include "core/refine/curvilinear/curvilinear_grid.h"
#include "core/refine/lattice/lattice_delaunay.h"

#include <Eigen/Geometry>

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The error of a mesh of a curvilinear grid where the grid's points lie in space (C12, R5): of the tetrahedra there
/// the one that comes closest counts, outside of all the nearest place on the boundary. For refinement that is to keep
/// it; tan/verify.h has a measure of its own. Some 40 bytes a point and 120 a site.
class SpaceErrors {
public:
    /// `extent`: of the values. The grid outlives it. O(n log^2 n).
    SpaceErrors(const CurvilinearGrid& grid, double extent);

    /// The worst point of a tetrahedron, or of a face on the boundary, which belongs to its tetrahedron.
    struct Worst {
        std::uint32_t point = 0;
        float error = 0; ///< a bound, weighted (R6)
        std::uint32_t slot = 0;
        std::array<PackedPoint, 4> tetrahedron{}; ///< what the slot held
    };
    /// The worse first, then the first in the grid.
    static bool isWorse(const Worst& one, const Worst& other)
    {
        return one.error != other.error ? one.error > other.error : one.point < other.point;
    }
    /// Of the tetrahedra of a whole grid (LatticeDelaunay::tetrahedra(), dead ones among them) a bound on the error at
    /// all points; to `found` it gives the worst of each tetrahedron that is worse than `limit`, by slots. Sites stay
    /// sites from one call to the next, as in a refinement: only what lies in tetrahedra that are new since is
    /// measured again. On all threads, the same with any number of them; O(tetrahedra + points), and the points in new
    /// tetrahedra or outside of all times the depth of trees.
    float measure(std::span<const DelaunayTetrahedron> tetrahedra, double limit, std::vector<Worst>& found);

    /// Of the same grid.
    void archive(StateArchive& archive)
    {
        for (std::atomic<std::uint64_t>& measured : measured_) {
            std::uint64_t bits = measured;
            archive(bits);
            measured = bits;
        }
        archive(tetrahedra_, isNew_, outside_);
    }

private:
    /// Points to be found by place.
    struct Places {
        std::vector<std::uint32_t> points;
        BoxTree tree;
        Eigen::AlignedBox3d box;
    };
    struct Boundary;

    Places placesOf(std::vector<std::uint32_t> points) const;
    void forget(std::span<const DelaunayTetrahedron> tetrahedra);
    void measureIn(const DelaunayTetrahedron& tetrahedron, std::uint32_t slot, const Places& places);
    void measureOutside(std::span<const DelaunayTetrahedron> tetrahedra, std::span<const std::uint32_t> points);
    void note(std::uint32_t point, double error, std::uint32_t slot);
    std::vector<std::uint32_t> notMeasuredYet() const;

    const CurvilinearGrid& grid_;
    double extent_;
    Places all_;
    std::vector<std::atomic<std::uint64_t>> measured_;   ///< of each point the bits of the least bound, then where
    std::vector<std::array<PackedPoint, 4>> tetrahedra_; ///< that were measured, by slots; of dead ones nothing
    std::vector<std::uint8_t> isNew_;                    ///< of these, since the last time
    std::vector<std::uint32_t> outside_;                 ///< points that no tetrahedron held
};

} // namespace tetra
