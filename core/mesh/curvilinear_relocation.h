// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/mesh/lifted_grid.h"
#include "core/mesh/star_placement.h"

#include <cstdint>
#include <span>

namespace tetra {

/// Distributes the points of a cavity over the tetrahedra of its star and finds their warpings and errors (R4, R5), the
/// inner loop of curvilinear refinement: the position and the value of a point less what the barycentric weights of
/// computational space make of its tetrahedron's vertices, all four components in one vector.
class CurvilinearRelocation {
public:
    /// The points must lie in the star. They may be in any order; the apex is passed over.
    void run(const LiftedGrid& grid, const Star& star, std::span<const PackedPoint> points);

    /// Face f of the star contains the points placed()[offsets()[f]] up to offsets()[f + 1].
    std::span<const PackedPoint> placed() const noexcept { return placement_.placed(); }
    std::span<const std::uint32_t> offsets() const noexcept { return placement_.offsets(); }
    /// The squares of (error * determinant) and of (warping * determinant) of each placed point, weighted
    /// (R6).
    std::span<const double> scaledSquaredErrors() const noexcept { return squaredErrors_; }
    std::span<const double> scaledSquaredWarpings() const noexcept { return squaredWarpings_; }

private:
    void weigh(const LiftedGrid& grid);

    StarPlacement placement_;
    Buffer<LiftedPoint> rim_;
    Buffer<double> squaredErrors_;
    Buffer<double> squaredWarpings_;
};

} // namespace tetra
