// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/greedy.h"

#include "core/mesh/topology.h"

#include <limits>
#include <numeric>

namespace tetra {

Result<std::vector<std::uint32_t>> addStart(std::span<const std::uint64_t> points,
                                            std::span<const StartTetrahedron> tetrahedra, HistorySink& sink)
{
    const auto latestSite = [&](std::uint32_t tetrahedron) { return std::ranges::max(tetrahedra[tetrahedron].sites); };
    std::vector<std::uint32_t> order(tetrahedra.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, latestSite);

    std::vector<std::uint32_t> numbers(tetrahedra.size());
    std::vector<HistoryTetrahedron> star;
    std::uint32_t count = 0;
    for (std::uint32_t site = 0; site < points.size(); ++site) {
        star.clear();
        for (; count < order.size() && latestSite(order[count]) == site; ++count) {
            const StartTetrahedron& tetrahedron = tetrahedra[order[count]];
            const auto latest =
                static_cast<std::size_t>(std::ranges::find(tetrahedron.sites, site) - tetrahedron.sites.begin());
            const auto& [a, b, c] = cornersOfFace[latest];
            star.push_back({{tetrahedron.sites[a], tetrahedron.sites[b], tetrahedron.sites[c]},
                            tetrahedron.error,
                            tetrahedron.warping});
            numbers[order[count]] = count;
        }
        if (const Status added = sink.add({points[site], std::numeric_limits<float>::infinity(), star, {}}); !added)
            return added.error();
    }
    return numbers;
}

} // namespace tetra
