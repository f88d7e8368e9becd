// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/relocation.h"

#include "core/mesh/cone_search.h"

#include <algorithm>

namespace tetra {

namespace {

/// Point arrays are padded to what the search tests at a time.
constexpr std::size_t lanes = coneSearchLanes;

} // namespace

void Relocation::gatherCoordinates(const PackedLattice& lattice, PackedPoint apex, std::span<const PackedPoint> points)
{
    points_.resize(points.size());
    std::size_t count = 0;
    for (const PackedPoint point : points) {
        points_[count] = point;
        count += point != apex;
    }
    points_.resize(count);
    const std::size_t padded = (count + lanes - 1) / lanes * lanes;
    x_.resize(padded);
    y_.resize(padded);
    z_.resize(padded);
    owners_.resize(padded);
    const std::int32_t apexX = lattice.x(apex), apexY = lattice.y(apex), apexZ = lattice.z(apex);
    for (std::size_t i = 0; i < count; ++i) {
        x_[i] = static_cast<float>(lattice.x(points_[i]) - apexX);
        y_[i] = static_cast<float>(lattice.y(points_[i]) - apexY);
        z_[i] = static_cast<float>(lattice.z(points_[i]) - apexZ);
    }
}

void Relocation::sortByOwner(std::size_t faceCount)
{
    offsets_.assign(faceCount + 2, 0);
    for (std::size_t i = 0; i < points_.size(); ++i)
        ++offsets_[static_cast<std::size_t>(owners_[i]) + 2];
    for (std::size_t face = 2; face < offsets_.size(); ++face)
        offsets_[face] += offsets_[face - 1];
    const std::size_t count = points_.size();
    placed_.resize(count);
    placedX_.resize(count);
    placedY_.resize(count);
    placedZ_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t place = offsets_[static_cast<std::size_t>(owners_[i]) + 1]++;
        placed_[place] = points_[i];
        placedX_[place] = x_[i];
        placedY_[place] = y_[i];
        placedZ_[place] = z_[i];
    }
    offsets_.pop_back();
}

void Relocation::run(const PackedLattice& lattice, const LatticeSamples& samples, const Star& star,
                     std::span<const PackedPoint> points)
{
    // The first insertions move millions of points, the later ones dozens: give the room of the first back.
    constexpr std::size_t roomWorthKeeping = 65536;
    if (points_.capacity() > std::max(roomWorthKeeping, 16 * points.size()))
        *this = Relocation();
    gatherCoordinates(lattice, star.apex(), points);
    findCones(star, {x_, y_, z_}, planes_, owners_);
    sortByOwner(star.faceCount());
    scaledErrors_.resize(placed_.size());
    divisors_.resize(star.faceCount());
    computeErrors(lattice, samples, star, {placed_, offsets_, placedX_, placedY_, placedZ_}, room_, scaledErrors_,
                  divisors_);
}

} // namespace tetra
