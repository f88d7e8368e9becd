// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/fine_stars.h"

#include "core/model/site_places.h"

#include <algorithm>

namespace tetra {

Result<FineStars> FineStars::make(const Model& model, std::uint32_t firstCreator, std::uint32_t sites,
                                  const Progress& progress)
{
    constexpr std::uint32_t creatorsAtOnce = 1 << 16;
    FineStars stars;
    stars.firstCreator_ = firstCreator;
    stars.siteCount_ = sites;
    if (firstCreator >= sites)
        return stars;
    if (const Status right = model.checkPrefix(sites, Model::Stars, progress.withCallback({})); !right)
        return right.error();
    model.check(model.meshSizes()[sites - 1]); // what it finds is known to checkIntact()
    const std::span<const std::uint64_t> offsets = model.starOffsets();
    stars.starts_.reserve(sites - firstCreator + 1);
    stars.keys_.reserve(std::min<std::uint64_t>(model.meshSizes()[sites - 1], model.tetrahedronCount()));
    std::uint64_t t = offsets[firstCreator];
    for (std::uint32_t creator = firstCreator; creator < sites; ++creator) {
        if (creator % creatorsAtOnce == 0) {
            if (progress.cancelled())
                return cancelledError("Looking at the history");
            progress.report(static_cast<double>(creator - firstCreator) / (sites - firstCreator),
                            "Looking at the history");
        }
        stars.starts_.push_back(static_cast<std::uint32_t>(stars.keys_.size()));
        const std::uint64_t end = offsets[creator + 1];
        if (end < t || end > model.tetrahedronCount())
            return inconsistentModel(model, "its star offsets make no sense");
        for (; t < end; ++t)
            if (model.destroyers()[t] >= sites) {
                const auto& [a, b, c] = model.otherSites()[t];
                stars.keys_.push_back(keyOf(a, b, c));
            }
    }
    stars.starts_.push_back(static_cast<std::uint32_t>(stars.keys_.size()));
    return stars;
}

bool FineStars::holds(const std::array<std::uint32_t, 4>& sites) const
{
    const std::size_t latest = static_cast<std::size_t>(std::ranges::max_element(sites) - sites.begin());
    const std::uint32_t creator = sites[latest];
    if (creator < firstCreator_ || creator >= siteCount_)
        return false;
    const std::uint64_t key = keyOf(sites[(latest + 1) % 4], sites[(latest + 2) % 4], sites[(latest + 3) % 4]);
    const std::uint64_t* const begin = keys_.data() + starts_[creator - firstCreator_];
    const std::uint64_t* const end = keys_.data() + starts_[creator - firstCreator_ + 1];
    bool found = false;
    for (const std::uint64_t* at = begin; at != end; ++at)
        found |= *at == key;
    return found;
}

} // namespace tetra
