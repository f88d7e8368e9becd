// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/lattice/lattice_delaunay.h"
#include "core/refine/lattice/lattice_samples.h"
#include "core/refine/lattice/packed_lattice.h"

#include <tan/base.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// A set of cells of a grid, in computational space, that says which tetrahedra meet them. Immutable. Made for the
/// folded cells of a curvilinear grid (FORMAT.md), of which most grids have none and some thousands.
class FoldedCells {
public:
    using Place = std::array<std::int32_t, 3>;
    using Corners = std::array<Place, 4>;

    FoldedCells() = default;
    /// `cells`: the first corner of each, distinct. O(n log n).
    explicit FoldedCells(std::vector<Place> cells);

    std::size_t count() const noexcept { return cells_.size(); }

    /// Whether the tetrahedron meets the interior of one of the cells. Its corners are points of the grid and in no
    /// plane. Exact where the grid has at most 2^32 points; O(log n) unless many cells lie around the tetrahedron that
    /// it misses.
    bool meet(const Corners& corners) const;

private:
    /// The cells [begin, end) in the box from `first` to `last`, in corners of cells. The nodes of its first half
    /// follow; those of its second begin at `second`, or there are none.
    struct Node {
        Place first{};
        Place last{};
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
        std::uint32_t second = 0;
    };

    std::uint32_t addNode(std::uint32_t begin, std::uint32_t end);

    std::vector<Place> cells_;
    std::vector<Node> nodes_;
};

/// A point of a curvilinear grid in physical space: x, y, z and the value, for arithmetic on all four at once.
struct alignas(32) PhysicalPoint {
    std::array<double, 4> components{};
    std::array<double, 3> position() const noexcept { return {components[0], components[1], components[2]}; }
};

/// What holds for a whole curvilinear grid, and for each of its blocks.
struct CurvilinearFacts {
    /// 1 if most of the corners of the grid's cells are positive in physical space, -1 if most are negative: a physical
    /// tetrahedron of the other sign is flipped (S5).
    int handedness = 1;
    /// Errors and warpings up to these cannot be told from none: rounding makes as much.
    double leastError = 0;
    double leastWarping = 0;
};

/// Looks at every point and every cell, on all threads; the result does not depend on how many. `positions` are all
/// finite.
CurvilinearFacts factsOf(const std::array<std::uint32_t, 3>& size, std::span<const Eigen::Vector3d> positions,
                         const LatticeSamples& samples);
/// Of a grid whose hand, and whose values and coordinates of the largest magnitudes, are known.
CurvilinearFacts factsOf(int handedness, double largestValue, double largestCoordinate);

/// What is known of a grid whose points are not: what else would be found by looking at all of them.
struct KnownOfGrid {
    CurvilinearFacts facts;
    FoldedCells foldedCells;
};

/// A curvilinear grid, or a box of one, in computational space (a lattice of unit spacing) with what lies in physical
/// space at each point. 32 bytes a point. Immutable.
class CurvilinearGrid {
public:
    /// `positions` holds one a point, all finite, in the lattice's order; values and weights come from `samples`.
    /// Nothing is referred to afterwards. Allocations throw std::bad_alloc.
    CurvilinearGrid(const std::array<std::uint32_t, 3>& size, std::span<const Eigen::Vector3d> positions,
                    const LatticeSamples& samples);
    /// The box of such a grid, its points counted in the box; `samples` are those of the box alone, `facts` those of
    /// the whole grid.
    CurvilinearGrid(const std::array<std::uint32_t, 3>& size, const LatticeBox& box,
                    std::span<const Eigen::Vector3d> positions, const LatticeSamples& samples,
                    const CurvilinearFacts& facts);
    /// The grid of which some points are not known: those of weight 0, whose positions mean nothing.
    CurvilinearGrid(const std::array<std::uint32_t, 3>& size, std::span<const Eigen::Vector3d> positions,
                    const LatticeSamples& samples, const KnownOfGrid& known);

    const PackedLattice& lattice() const noexcept { return lattice_; }
    const PhysicalPoint& operator[](std::uint32_t index) const noexcept { return points_[index]; }
    const PhysicalPoint& at(PackedPoint point) const noexcept { return points_[lattice_.index(point)]; }
    std::array<double, 3> position(PackedPoint point) const noexcept { return at(point).position(); }

    /// Whether points have weights that multiply their errors and warpings (R6); weight() only if so.
    bool weighted() const noexcept { return !weights_.empty(); }
    double weight(PackedPoint point) const noexcept { return weights_[lattice_.index(point)]; }

    int handedness() const noexcept { return facts_.handedness; }
    /// The sign of a tetrahedron's volume in physical space, relative to the handedness; exact. 1 is consistent, 0
    /// degenerate (S6), -1 flipped. `vertices` must be positive in computational space.
    int orientation(const std::array<PackedPoint, 4>& vertices) const;
    /// The cells that have a flipped corner: the tetrahedron of a corner and its neighbours along the cell's edges.
    const FoldedCells& foldedCells() const noexcept { return foldedCells_; }
    /// Whether a tetrahedron, if it is flipped, may stay so at every level (S5, FORMAT.md): it meets the interior of a
    /// folded cell, or all of its vertices belong to one cell, so that no point of the grid could cure it. Exact.
    bool allowsInverted(const std::array<PackedPoint, 4>& vertices) const;

    double leastError() const noexcept { return facts_.leastError; }
    double leastWarping() const noexcept { return facts_.leastWarping; }

private:
    void fill(const std::array<std::uint32_t, 3>& size, const LatticeBox& box,
              std::span<const Eigen::Vector3d> positions, const LatticeSamples& samples);
    void findFoldedCells();

    PackedLattice lattice_;
    Buffer<PhysicalPoint> points_;
    Buffer<float> weights_;
    CurvilinearFacts facts_;
    FoldedCells foldedCells_;
};

/// Of the lattice points in `box` strictly inside the circumsphere of `tetrahedron`, the one nearest to its centre
/// (ties go to the first in the lattice), or none. Unit spacing. Exact, O(1). In a Delaunay mesh of the box no vertex
/// lies strictly inside, so what is found is not a vertex yet.
std::optional<PackedPoint> deepestPointInSphere(const PackedLattice& lattice, const DelaunayTetrahedron& tetrahedron,
                                                const LatticeBox& box);

} // namespace tetra
