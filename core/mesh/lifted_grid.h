// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/mesh/folded_cells.h"
#include "core/mesh/lattice_samples.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// A point of a curvilinear grid lifted into physical space: x, y, z and the value, for arithmetic on all four at once.
struct alignas(32) LiftedPoint {
    std::array<double, 4> components{};
    std::array<double, 3> position() const noexcept { return {components[0], components[1], components[2]}; }
};

/// A curvilinear grid in computational space (a lattice of unit spacing) with what lies in physical space at each
/// point. 32 bytes a point. Immutable.
class LiftedGrid {
public:
    /// `positions` holds one a point, all finite, in the lattice's order; values and weights come from `samples`.
    /// Nothing is referred to afterwards. Allocations throw std::bad_alloc.
    LiftedGrid(const std::array<std::uint32_t, 3>& size, std::span<const Eigen::Vector3d> positions,
               const LatticeSamples& samples);

    const PackedLattice& lattice() const noexcept { return lattice_; }
    const LiftedPoint& operator[](std::uint32_t index) const noexcept { return points_[index]; }
    const LiftedPoint& at(PackedPoint point) const noexcept { return points_[lattice_.index(point)]; }
    std::array<double, 3> position(PackedPoint point) const noexcept { return at(point).position(); }

    /// Whether points have weights that multiply their errors and warpings (R6); weight() only if so.
    bool weighted() const noexcept { return !weights_.empty(); }
    double weight(PackedPoint point) const noexcept { return weights_[lattice_.index(point)]; }

    /// 1 if most of the corners of the grid's cells are positive in physical space, -1 if most are negative: a lifted
    /// tetrahedron of the other sign is flipped (S5).
    int handedness() const noexcept { return handedness_; }
    /// The sign of a tetrahedron's volume in physical space, relative to the handedness; exact. 1 is consistent, 0
    /// degenerate (S6), -1 flipped. `vertices` must be positive in computational space.
    int orientation(const std::array<PackedPoint, 4>& vertices) const;
    /// The cells that have a flipped corner: the tetrahedron of a corner and its neighbours along the cell's edges.
    const FoldedCells& foldedCells() const noexcept { return foldedCells_; }
    /// Whether a tetrahedron, if it is flipped, may stay so at every level (S5, FORMAT.md): it meets the interior of a
    /// folded cell, or all of its vertices belong to one cell, so that no point of the grid could cure it. Exact.
    bool bears(const std::array<PackedPoint, 4>& vertices) const;

    /// Errors and warpings below these cannot be told from none: rounding makes as much.
    double leastError() const noexcept { return leastError_; }
    double leastWarping() const noexcept { return leastWarping_; }

private:
    void lookAtCells();

    PackedLattice lattice_;
    Buffer<LiftedPoint> points_;
    Buffer<float> weights_;
    int handedness_ = 1;
    FoldedCells foldedCells_;
    double leastError_ = 0;
    double leastWarping_ = 0;
};

} // namespace tetra
