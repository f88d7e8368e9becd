// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/site_grid.h"

#include <algorithm>

namespace tetra {

std::optional<SiteGrid> SiteGrid::make(const PackedLattice& lattice, std::span<const std::uint32_t> points)
{
    SiteGrid grid;
    const auto& size = lattice.size();
    for (std::size_t axis = 0; axis < 3; ++axis)
        grid.counts_[axis] = (size[axis] + edge - 1) / edge;
    const std::uint64_t pointCount = std::uint64_t(size[0]) * size[1] * size[2];
    Buffer<PackedPoint> packed(points.size());
    for (std::size_t site = 0; site < points.size(); ++site) {
        const std::uint32_t point = points[site];
        if (point >= pointCount)
            return std::nullopt;
        const std::uint32_t row = point / size[0];
        packed[site] = lattice.pack(point - row * size[0], row % size[1], row / size[1]);
    }
    const auto cellOf = [&](PackedPoint point) {
        const auto part = [](std::int32_t coordinate) { return std::uint64_t(coordinate) / edge; };
        return (part(lattice.z(point)) * grid.counts_[1] + part(lattice.y(point))) * grid.counts_[0] +
               part(lattice.x(point));
    };
    grid.starts_.assign(std::uint64_t(grid.counts_[0]) * grid.counts_[1] * grid.counts_[2] + 2, 0);
    for (const PackedPoint point : packed)
        ++grid.starts_[cellOf(point) + 2];
    for (std::size_t cell = 2; cell < grid.starts_.size(); ++cell)
        grid.starts_[cell] += grid.starts_[cell - 1];
    grid.sites_.resize(points.size());
    for (std::uint32_t site = 0; site < packed.size(); ++site)
        grid.sites_[grid.starts_[cellOf(packed[site]) + 1]++] = {site, packed[site]};
    return grid;
}

std::optional<std::uint32_t> SiteGrid::siteAt(const PackedLattice& lattice, PackedPoint point) const
{
    const std::array<std::int32_t, 3> place = {lattice.x(point), lattice.y(point), lattice.z(point)};
    std::optional<std::uint32_t> found;
    forEachCell(place, place, [&](const auto&, std::span<const Site> sites) {
        const auto site = std::ranges::find(sites, point, &Site::point);
        if (site != sites.end())
            found = site->number;
    });
    return found;
}

} // namespace tetra
