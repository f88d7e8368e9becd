// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/lattice_samples.h"
#include "core/mesh/star.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Distributes the points of a cavity over the tetrahedra of its star and finds their errors, the inner loop of
/// refinement. Exact: a point's tetrahedron by signs of integers, its error as an integer over the determinant for
/// integer samples of up to 16 bits (S8, S9). A point on a shared face belongs to the star's first tetrahedron that has
/// it.
class Relocation {
public:
    /// The points must lie in the star. They may be in any order; the apex is passed over.
    void run(const PackedLattice& lattice, const LatticeSamples& samples, const Star& star,
             std::span<const PackedPoint> points);

    /// Face f of the star contains the points placed()[offsets()[f]] up to offsets()[f + 1].
    std::span<const PackedPoint> placed() const noexcept { return placed_; }
    std::span<const std::uint32_t> offsets() const noexcept { return offsets_; }
    /// |value - interpolation| * determinant of each placed point.
    std::span<const double> scaledErrors() const noexcept { return scaledErrors_; }

private:
    void gatherCoordinates(const PackedLattice& lattice, PackedPoint apex, std::span<const PackedPoint> points);
    void sortByOwner(std::size_t faceCount);
    void computeErrors(const PackedLattice& lattice, const LatticeSamples& samples, const Star& star);

    Buffer<PackedPoint> points_;
    Buffer<float> x_, y_, z_;
    Buffer<std::int32_t> owners_;
    Buffer<PackedPoint> placed_;
    Buffer<float> placedX_, placedY_, placedZ_;
    std::vector<std::uint32_t> offsets_;
    Buffer<double> values_;
    Buffer<double> scaledErrors_;
    Buffer<double> rimValues_;
    Buffer<float> planes_;
};

} // namespace tetra
