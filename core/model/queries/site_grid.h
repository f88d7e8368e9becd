// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/mesh/packed_lattice.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// The sites of a lattice model by where they lie: cells of 8^3 points, each with its sites in rising order. 8 bytes a
/// site. Making it takes two passes over the sites.
class SiteGrid {
public:
    static constexpr std::uint32_t edge = 8;
    struct Site {
        std::uint32_t number;
        PackedPoint point;
    };

    SiteGrid() = default;
    /// Of points given by their indices in the lattice. None if an index is too large.
    static std::optional<SiteGrid> make(const PackedLattice& lattice, std::span<const std::uint32_t> points);

    /// Calls visit(first point, sites) for each cell that has points between the two, ends included.
    template <class Visit> void forEachCell(const std::array<std::int32_t, 3>& first,
                                            const std::array<std::int32_t, 3>& last, Visit&& visit) const
    {
        for (std::int32_t z = first[2] / step; z <= floorOf(last[2]); ++z)
            for (std::int32_t y = first[1] / step; y <= floorOf(last[1]); ++y)
                for (std::int32_t x = first[0] / step; x <= floorOf(last[0]); ++x)
                    visit(std::array<std::uint32_t, 3>{std::uint32_t(x) * edge, std::uint32_t(y) * edge,
                                                       std::uint32_t(z) * edge},
                          cell((std::uint64_t(z) * counts_[1] + std::uint64_t(y)) * counts_[0] + std::uint64_t(x)));
    }
    /// The site at a point, or none.
    std::optional<std::uint32_t> siteAt(const PackedLattice& lattice, PackedPoint point) const;

private:
    static constexpr std::int32_t step = edge;
    static std::int32_t floorOf(std::int32_t coordinate) { return coordinate < 0 ? -1 : coordinate / step; }
    std::span<const Site> cell(std::uint64_t number) const
    {
        return std::span(sites_).subspan(starts_[number], starts_[number + 1] - starts_[number]);
    }

    std::array<std::uint32_t, 3> counts_{};
    std::vector<std::uint32_t> starts_{0};
    Buffer<Site> sites_;
};

} // namespace tetra
