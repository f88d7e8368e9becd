// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/history_batch.h"

#include "core/mesh/topology.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tetra {

void HistoryBatch::start(std::uint32_t firstSite, std::uint32_t firstTetrahedron)
{
    firstSite_ = firstSite;
    firstTetrahedron_ = firstTetrahedron;
    points_.clear();
    groups_.reset(0);
    tetrahedra_.clear();
}

void HistoryBatch::add(const HistoryStep& step)
{
    const std::uint32_t local = siteCount();
    points_.push_back(step.point);
    groups_.add();
    for (const HistoryTetrahedron& made : step.star) {
        tetrahedra_.push_back(
            {{firstSite_ + local, made.sites[0], made.sites[1], made.sites[2]}, made.error, made.warping});
        for (const std::uint32_t site : made.sites)
            if (site >= firstSite_)
                groups_.join(local, site - firstSite_);
    }
    for (const std::uint32_t destroyed : step.destroyed)
        if (destroyed >= firstTetrahedron_) {
            Tetrahedron& tetrahedron = tetrahedra_[destroyed - firstTetrahedron_];
            tetrahedron.dropped = true;
            groups_.join(local, tetrahedron.sites[0] - firstSite_);
        }
}

void HistoryBatch::uniteAll()
{
    for (std::uint32_t local = 1; local < siteCount(); ++local)
        groups_.join(0, local);
}

void HistoryBatch::arrange()
{
    const std::uint32_t count = siteCount();
    firsts_.resize(count);
    std::iota(firsts_.begin(), firsts_.end(), 0u);
    for (std::uint32_t local = 0; local < count; ++local) {
        std::uint32_t& first = firsts_[groups_.root(local)];
        if (points_[local] < points_[first])
            first = local;
    }
    for (std::uint32_t local = 0; local < count; ++local)
        firsts_[local] = firsts_[groups_.root(local)];
    order_.resize(count);
    std::iota(order_.begin(), order_.end(), 0u);
    if (count > 1)
        std::ranges::sort(order_, {},
                          [this](std::uint32_t local) { return std::pair(points_[firsts_[local]], points_[local]); });
    places_.resize(count);
    for (std::uint32_t place = 0; place < count; ++place)
        places_[order_[place]] = place;
}

std::array<std::uint32_t, 4> latestFirst(const std::array<std::uint32_t, 4>& sites)
{
    return withCornerFirst(sites, static_cast<std::size_t>(std::ranges::max_element(sites) - sites.begin()));
}

} // namespace tetra
