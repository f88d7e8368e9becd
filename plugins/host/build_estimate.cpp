// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/build_estimate.h"

namespace tetra {

BuildSize buildSizeOf(const Dataset& dataset, const Progress& progress)
{
    return {.domain = dataset.domain,
            .points = dataset.pointCount(),
            .tetrahedra = dataset.tetrahedra ? dataset.tetrahedra->size() : 0,
            .convex = dataset.convex,
            .type = dataset.values.type(),
            .density = SiteDensity::of(dataset, progress)};
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
