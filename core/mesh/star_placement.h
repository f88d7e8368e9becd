// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/mesh/star.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Which of a star's tetrahedra each point of its cavity lies in. Exact (S8); a point on a shared face goes to one of
/// them by a fixed rule (S9), that of findCones().
class StarPlacement {
public:
    /// The points must lie in the star. They may be in any order; the apex is passed over.
    void run(const PackedLattice& lattice, const Star& star, std::span<const PackedPoint> points);

    /// Face f of the star contains the points placed()[offsets()[f]] up to offsets()[f + 1].
    std::span<const PackedPoint> placed() const noexcept { return placed_; }
    std::span<const std::uint32_t> offsets() const noexcept { return offsets_; }
    /// The coordinates of each placed point relative to the apex, the fourth 0.
    std::span<const std::array<float, 4>> coordinates() const noexcept { return placedCoordinates_; }

private:
    void gatherCoordinates(const PackedLattice& lattice, PackedPoint apex, std::span<const PackedPoint> points);
    void sortByOwner(std::size_t faceCount);

    Buffer<PackedPoint> points_;
    Buffer<float> x_, y_, z_;
    Buffer<std::int32_t> owners_;
    Buffer<PackedPoint> placed_;
    Buffer<std::array<float, 4>> placedCoordinates_;
    std::vector<std::uint32_t> offsets_;
    Buffer<std::array<float, 12>> planes_;
};

} // namespace tetra
