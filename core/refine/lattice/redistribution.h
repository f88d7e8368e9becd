// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/lattice/lattice_samples.h"
#include "core/refine/lattice/star.h"

#include <tan/base.h>

#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace tetra {

/// Memory to work in, used again.
struct PointErrorScratch {
    Buffer<double> values;
    Buffer<double> rimValues;
    Buffer<std::array<double, 4>> planes;
};

/// Distributes the points of a cavity over the tetrahedra of its star and finds their errors, the inner loop of
/// refinement. Exact: a point's tetrahedron by signs of integers (S8, S9). A point on a shared face belongs to one of
/// the star's tetrahedra that have it; its error is the same in all of them.
class Redistribution {
public:
    /// The points must lie in the star, in any order, without the apex; they are copied.
    void run(const PackedLattice& lattice, const LatticeSamples& samples, const Star& star,
             std::span<const PackedPoint> points);

    std::span<const PackedPoint> points() const noexcept { return points_; }
    /// The star's tetrahedron that has each point.
    std::span<const std::int32_t> owners() const noexcept { return {owners_.data(), points_.size()}; }
    /// The error of each point, before it is rounded up to a float.
    std::span<const double> errors() const noexcept { return {errors_.data(), points_.size()}; }

    /// How many points a tetrahedron of the star has.
    std::uint32_t count(std::size_t face) const noexcept { return faces_[face].count; }
    /// Of a tetrahedron with points: the largest error, rounded up to a float, and the first point of the lattice that
    /// has it *after rounding*: the queue orders points in the same way.
    float worstError(std::size_t face) const noexcept
    {
        return std::bit_cast<float>(static_cast<std::uint32_t>(faces_[face].worst >> 32));
    }
    PackedPoint worstPoint(std::size_t face) const noexcept { return ~static_cast<PackedPoint>(faces_[face].worst); }

private:
    struct FacePoints {
        std::uint64_t worst; ///< the bits of the error, then the complement of the point
        std::uint32_t count;
    };

    inline void findWorst(std::size_t faceCount); // called by dispatch()

    Buffer<PackedPoint> points_;
    Buffer<float> x_, y_, z_;
    Buffer<std::int32_t> owners_;
    Buffer<double> errors_;
    Buffer<std::uint64_t> keys_;
    Buffer<FacePoints> faces_;
    Buffer<std::array<float, 12>> planes_;
    PointErrorScratch scratch_;
};

} // namespace tetra
