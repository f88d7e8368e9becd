// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/lattice_samples.h"
#include "core/mesh/point_errors.h"
#include "core/mesh/star.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Distributes the points of a cavity over the tetrahedra of its star and finds their errors, the inner loop of
/// refinement. Exact: a point's tetrahedron by signs of integers (S8, S9). A point on a shared face belongs to one of
/// the star's tetrahedra that have it; its error is the same in all of them.
class Relocation {
public:
    /// The points must lie in the star. They may be in any order; the apex is passed over.
    void run(const PackedLattice& lattice, const LatticeSamples& samples, const Star& star,
             std::span<const PackedPoint> points);

    /// Face f of the star contains the points placed()[offsets()[f]] up to offsets()[f + 1].
    std::span<const PackedPoint> placed() const noexcept { return placed_; }
    std::span<const std::uint32_t> offsets() const noexcept { return offsets_; }
    /// The error of each placed point times the divisor of its face.
    std::span<const double> scaledErrors() const noexcept { return scaledErrors_; }
    std::span<const double> divisors() const noexcept { return divisors_; }

private:
    void gatherCoordinates(const PackedLattice& lattice, PackedPoint apex, std::span<const PackedPoint> points);
    void sortByOwner(std::size_t faceCount);

    Buffer<PackedPoint> points_;
    Buffer<float> x_, y_, z_;
    Buffer<std::int32_t> owners_;
    Buffer<PackedPoint> placed_;
    Buffer<float> placedX_, placedY_, placedZ_;
    std::vector<std::uint32_t> offsets_;
    Buffer<double> scaledErrors_;
    Buffer<double> divisors_;
    PointErrorRoom room_;
    Buffer<float> planes_;
};

} // namespace tetra
