// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/model/queries/field_judge.h"
#include "core/model/queries/site_set.h"
#include "core/model/queries/stars.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace tetra {

/// The tetrahedra that the site created, that none of the sites destroys, and that may be coarser than the judge
/// allows. In `buffer`, which is used from star to star: written without a branch on what no processor could predict.
inline std::span<const std::uint64_t> coarseCandidates(const Model& model, const SiteSet& sites,
                                                       const FieldJudge& judge, std::uint32_t site,
                                                       Buffer<std::uint64_t>& buffer)
{
    const auto star = starOf(model, site);
    if (buffer.size() <= star.size())
        buffer.resize(2 * star.size() + 1);
    std::size_t count = 0;
    for (const std::uint64_t t : star) {
        const bool stays = !sites.contains(std::min(model.destroyers()[t], model.siteCount()));
        buffer[count] = t;
        count += static_cast<std::size_t>(stays & judge.mayBeTooCoarse(t));
    }
    return std::span(buffer).first(count);
}

} // namespace tetra
