// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/build_estimate.h"

#include <algorithm>

namespace tetra {

namespace {

/// Whether the field bends at a point: is not the mean of its two neighbours along some axis.
template <class T> bool bends(std::span<const T> samples, const Lattice& lattice, std::uint64_t point)
{
    const auto place = lattice.coordinates(point);
    std::uint64_t step = 1;
    for (std::size_t axis = 0; axis < 3; step *= lattice.size[axis], ++axis) {
        if (place[axis] == 0 || place[axis] + 1 == lattice.size[axis])
            continue;
        const auto sum = static_cast<double>(samples[point - step]) + static_cast<double>(samples[point + step]);
        if (sum != 2 * static_cast<double>(samples[point]))
            return true;
    }
    return false;
}

double shareOfBends(const Dataset& dataset)
{
    constexpr std::uint64_t sampled = 8192;
    constexpr std::uint64_t scatter = 0x9e3779b97f4a7c15; // odd: the golden ratio, which spreads evenly
    const std::uint64_t count = dataset.pointCount();
    const std::uint64_t looked = std::min(count, sampled);
    std::uint64_t bent = 0;
    visitSampleType(dataset.values.type(), [&]<class T>() {
        for (std::uint64_t i = 0; i < looked; ++i) {
            const auto fraction = static_cast<double>(i * scatter >> 11) / static_cast<double>(std::uint64_t(1) << 53);
            const auto point = std::min(static_cast<std::uint64_t>(fraction * static_cast<double>(count)), count - 1);
            bent += bends(dataset.values.as<T>(), dataset.lattice, point);
        }
    });
    return static_cast<double>(bent) / static_cast<double>(looked);
}

} // namespace

BuildSize buildSizeOf(const Dataset& dataset)
{
    BuildSize size{.domain = dataset.domain,
                   .points = dataset.pointCount(),
                   .tetrahedra = dataset.tetrahedra ? dataset.tetrahedra->size() : 0,
                   .type = dataset.values.type()};
    if (dataset.domain == DomainClass::RegularLattice)
        size.siteShare = shareOfBends(dataset);
    return size;
}

std::optional<BuildEstimate> quickestEstimate(PluginHost& host, const BuildSize& size, unsigned threads)
{
    std::optional<BuildEstimate> quickest;
    for (const auto& builder : host.builders())
        if (const auto estimate = builder.plugin->estimate(size, {}, threads))
            if (!quickest || estimate->seconds < quickest->seconds)
                quickest = estimate;
    return quickest;
}

} // namespace tetra
