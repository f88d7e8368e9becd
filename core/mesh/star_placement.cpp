// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/star_placement.h"

#include "core/mesh/cone_search.h"

namespace tetra {

void StarPlacement::gatherCoordinates(const PackedLattice& lattice, PackedPoint apex,
                                      std::span<const PackedPoint> points)
{
    points_.resize(points.size());
    std::size_t count = 0;
    for (const PackedPoint point : points) {
        points_[count] = point;
        count += point != apex;
    }
    points_.resize(count);
    const std::size_t padded = (count + coneSearchLanes - 1) / coneSearchLanes * coneSearchLanes;
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

void StarPlacement::sortByOwner(std::size_t faceCount)
{
    offsets_.assign(faceCount + 2, 0);
    for (std::size_t i = 0; i < points_.size(); ++i)
        ++offsets_[static_cast<std::size_t>(owners_[i]) + 2];
    for (std::size_t face = 2; face < offsets_.size(); ++face)
        offsets_[face] += offsets_[face - 1];
    placed_.resize(points_.size());
    placedCoordinates_.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const std::uint32_t place = offsets_[static_cast<std::size_t>(owners_[i]) + 1]++;
        placed_[place] = points_[i];
        placedCoordinates_[place] = {x_[i], y_[i], z_[i], 0};
    }
    offsets_.pop_back();
}

void StarPlacement::run(const PackedLattice& lattice, const Star& star, std::span<const PackedPoint> points)
{
    // The first insertions move millions of points, the later ones dozens: give the room of the first back.
    constexpr std::size_t roomWorthKeeping = 65536;
    if (points_.capacity() > std::max(roomWorthKeeping, 16 * points.size()))
        *this = StarPlacement();
    gatherCoordinates(lattice, star.apex(), points);
    findCones(star, {x_, y_, z_}, planes_, owners_);
    sortByOwner(star.faceCount());
}

} // namespace tetra
