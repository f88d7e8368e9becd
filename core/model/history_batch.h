// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/disjoint_sets.h"
#include "core/mesh/history.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The steps of a history between which the running key did not fall: no query separates them (S1), so what is born
/// and dies within is left out. Sites linked by what they do to each other's tetrahedra form a group. What an order of
/// the groups means does not depend on it, so a canonical one is taken: groups by their first point, sites by their
/// point. Numbers are those of the builder unless they are called places: 0 is the batch's first in canonical order.
class HistoryBatch {
public:
    struct Tetrahedron {
        std::array<std::uint32_t, 4> sites; ///< positive; the first one made it
        float error = 0;
        float warping = 0;
        bool dropped = false; ///< died within the batch
    };

    /// Forgets everything; the next step makes site `firstSite` and tetrahedra from `firstTetrahedron` on.
    void start(std::uint32_t firstSite, std::uint32_t firstTetrahedron);
    /// The step's sites and tetrahedra exist. May throw std::bad_alloc, as may the other members that change anything.
    void add(const HistoryStep& step);
    /// Makes one group of all sites: the mesh that they start from has no parts.
    void uniteAll();
    /// Finds the canonical order; comes after the last step.
    void arrange();

    std::uint32_t firstSite() const noexcept { return firstSite_; }
    std::uint32_t siteCount() const noexcept { return static_cast<std::uint32_t>(points_.size()); }
    std::uint32_t firstTetrahedron() const noexcept { return firstTetrahedron_; }
    std::span<const Tetrahedron> tetrahedra() const noexcept { return tetrahedra_; }

    /// The point of the site at `place`.
    std::uint64_t pointAt(std::uint32_t place) const { return points_[order_[place]]; }
    /// Whether the site at the next place belongs to the same group.
    bool groupGoesOn(std::uint32_t place) const
    {
        return place + 1 < siteCount() && firsts_[order_[place]] == firsts_[order_[place + 1]];
    }
    /// Where a site of this batch went.
    std::uint32_t placeOf(std::uint32_t site) const { return places_[site - firstSite_]; }

private:
    std::uint32_t firstSite_ = 0;
    std::uint32_t firstTetrahedron_ = 0;
    std::vector<std::uint64_t> points_;
    DisjointSets groups_;
    std::vector<std::uint32_t> firsts_; ///< of each site, after arrange(): the site of its group's first point
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> places_;
    std::vector<Tetrahedron> tetrahedra_;
};

/// The sites of a positive tetrahedron with the latest brought to the front, still positive.
std::array<std::uint32_t, 4> latestFirst(const std::array<std::uint32_t, 4>& sites);

} // namespace tetra
