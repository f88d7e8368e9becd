// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/inverted_cells.h"

#include "core/geometry/orientation.h"
#include "core/history/site_positions.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <functional>

namespace tetra {

namespace {

/// Adds to `counts` the inverted tetrahedra that a site created, for each of the meshes that has them.
void countInvertedOf(const Model& model, std::uint32_t creator, std::span<const std::uint32_t> sites,
                     std::vector<std::uint64_t>& counts)
{
    const int inverted = model.description().leftHanded ? 1 : -1;
    const auto place = [&](std::uint32_t site) {
        const Eigen::Vector3d position = model.position(std::min(site, creator));
        return std::array<double, 3>{position.x(), position.y(), position.z()};
    };
    for (std::uint64_t t = model.starOffsets()[creator]; t < model.starOffsets()[creator + 1]; ++t) {
        const auto has = [creator, destroyer = model.destroyers()[t]](std::uint32_t count) {
            return creator < count && count <= destroyer;
        };
        if (std::ranges::none_of(sites, has))
            continue;
        const auto& [a, b, c] = model.otherSites()[t];
        if (orientationSign(place(creator), place(a), place(b), place(c)) != inverted)
            continue;
        for (std::size_t mesh = 0; mesh < sites.size(); ++mesh)
            counts[mesh] += has(sites[mesh]) ? 1 : 0;
    }
}

} // namespace

Result<std::vector<std::uint64_t>> countInverted(const Model& model, std::span<const std::uint32_t> sites)
{
    using Counts = std::vector<std::uint64_t>;
    const Counts none(sites.size(), 0);
    if (model.description().domain != DomainClass::Curvilinear)
        return none;
    if (const Status right = model.checkPrefix(model.siteCount(), Model::Stars); !right)
        return right.error();
    if (!model.check(model.floatPositions()) || !model.check(model.doublePositions()))
        return model.checkIntact().error();
    if (!std::ranges::is_sorted(model.starOffsets()) || model.starOffsets().back() != model.tetrahedronCount())
        return inconsistentModel(model, "its tetrahedra are not in the order of their sites");
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(0, model.siteCount()), none,
        [&](const auto& range, Counts counts) {
            for (std::uint32_t creator = range.begin(); creator != range.end(); ++creator)
                countInvertedOf(model, creator, sites, counts);
            return counts;
        },
        [](Counts a, const Counts& b) {
            std::ranges::transform(a, b, a.begin(), std::plus());
            return a;
        });
}

} // namespace tetra
