// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/history_links.h"

#include "core/history/site_positions.h"
#include "core/history/walk.h"

#include <algorithm>
#include <numeric>

namespace tetra {

namespace {

/// Calls `link(site, parent)` for every site and each of its parents, parents ascending.
template <class Link> Status visitLinks(const Model& model, std::uint32_t sites, Buffer<std::uint32_t>& lastParents,
                                        const Progress& progress, const Link& link)
{
    lastParents.assign(sites, Model::never);
    const auto visit = [&](const Stars& stars) -> Status {
        bool right = true;
        forEachAlive(stars, 0, [&](std::uint32_t creator, std::uint64_t, std::uint32_t destroyer) {
            if (destroyer >= sites || lastParents[destroyer] == creator)
                return;
            right &= destroyer > creator;
            lastParents[destroyer] = creator;
            link(destroyer, creator);
        });
        return right ? Status() : inconsistentModel(model, "a tetrahedron dies before it is made");
    };
    return walkHistory(model, 0, sites, progress, "Looking at the history", visit);
}

} // namespace

Status HistoryLinks::cover(const Model& model, std::uint32_t sites, const Progress& progress)
{
    if (sites <= siteCount_)
        return {};
    siteCount_ = 0;
    Buffer<std::uint32_t> lastParents;
    offsets_.assign(sites + std::size_t(2), 0);
    if (const Status counted = visitLinks(model, sites, lastParents, progress.part(0, 0.5),
                                          [this](std::uint32_t site, std::uint32_t) { ++offsets_[site + 2]; });
        !counted)
        return counted;
    std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
    const std::uint64_t count = offsets_.back();
    parents_.resize(count);
    bool same = true; // the file may be changed between the passes
    const auto fill = [this, count, &same](std::uint32_t site, std::uint32_t parent) {
        std::uint64_t& place = offsets_[site + 1];
        if (place < count)
            parents_[place++] = parent;
        else
            same = false;
    };
    if (const Status filled = visitLinks(model, sites, lastParents, progress.part(0.5, 1), fill); !filled)
        return filled;
    if (!same || !std::ranges::is_sorted(offsets_) || offsets_[sites] != count)
        return inconsistentModel(model, "its destroyers changed while they were read");
    offsets_.pop_back();
    siteCount_ = sites;
    return {};
}

} // namespace tetra
