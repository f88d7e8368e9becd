// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/history_links.h"

#include "core/history/site_positions.h"

#include <algorithm>
#include <numeric>

namespace tetra {

namespace {

/// Calls `link(site, parent)` for every site and each of its parents, parents ascending.
template <class Link> Status visitLinks(const Model& model, std::uint32_t sites, Buffer<std::uint32_t>& lastParents,
                                        const Progress& progress, const Link& link)
{
    constexpr std::uint32_t sitesAtOnce = 1 << 16;
    lastParents.assign(sites, Model::never);
    const std::span<const std::uint32_t> destroyers = model.destroyers();
    for (std::uint32_t creator = 0; creator < sites; ++creator) {
        if (creator % sitesAtOnce == 0) {
            if (progress.cancelled())
                return cancelledError("Looking at the history");
            progress.report(static_cast<double>(creator) / sites, "Looking at the history");
        }
        for (const std::uint64_t t : starOf(model, creator)) {
            const std::uint32_t destroyer = destroyers[t];
            if (destroyer >= sites || lastParents[destroyer] == creator)
                continue;
            if (destroyer <= creator)
                return inconsistentModel(model, "a tetrahedron dies before it is made");
            lastParents[destroyer] = creator;
            link(destroyer, creator);
        }
    }
    return {};
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
