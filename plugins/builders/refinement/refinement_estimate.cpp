// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/refinement_estimate.h"

#include <algorithm>
#include <cmath>

namespace tetra {

namespace {

/// What a build of one kind takes, measured (docs/performance.md, "Estimates").
struct Costs {
    double fixedBytes = 30e6;  ///< of memory: the program
    double pointBytes = 0;     ///< of memory, for each point ...
    double siteBytes = 0;      ///< ... and besides for each site
    double modelSiteBytes = 0; ///< of the file, for each site
    double diskFactor = 1;     ///< of disk while it is built, over the model
    double siteSeconds = 0;    ///< on one thread, for each site
    double pointSeconds = 0;   ///< likewise for each point
    bool usesThreads = false;
};

Costs costsOf(const BuildSize& size, bool inBlocks)
{
    const auto points = static_cast<double>(size.points);
    if (size.domain == DomainClass::Scattered)
        return {.pointBytes = 60, .siteBytes = 700, .modelSiteBytes = 440, .siteSeconds = 25e-6};
    if (size.domain == DomainClass::Curvilinear)
        return {.pointBytes = 60, .siteBytes = 600, .modelSiteBytes = 340, .siteSeconds = 7e-6};
    if (inBlocks)
        return {.fixedBytes = 100e6,
                .siteBytes = 45,
                .modelSiteBytes = 300,
                .diskFactor = 1.65,
                .siteSeconds = 7.5e-6,
                .pointSeconds = 0.08e-6,
                .usesThreads = true};
    const double memoryMisses = std::clamp(std::log2(points / 32768) / 6, 0.0, 1.0); // 0 at 32^3, 1 at 128^3
    return {.pointBytes = 160,
            .siteBytes = 450,
            .modelSiteBytes = 295,
            .siteSeconds = (4 + 3 * memoryMisses) * 1e-6,
            .pointSeconds = 0.1e-6};
}

} // namespace

BuildEstimate estimateRefinement(const BuildSize& size, double error, bool inBlocks, unsigned threads)
{
    const Costs costs = costsOf(size, inBlocks);
    const auto points = static_cast<double>(size.points);
    const double sites = std::max(points * size.density.share(error), 8.0);
    const double data = points * static_cast<double>(sampleSize(size.type));
    BuildEstimate estimate;
    estimate.modelBytes = static_cast<std::uint64_t>(sites * costs.modelSiteBytes + 4096);
    estimate.diskBytes = static_cast<std::uint64_t>(static_cast<double>(estimate.modelBytes) * costs.diskFactor);
    estimate.memoryBytes =
        static_cast<std::uint64_t>(costs.fixedBytes + data + points * costs.pointBytes + sites * costs.siteBytes);
    estimate.seconds =
        (sites * costs.siteSeconds + points * costs.pointSeconds) / (costs.usesThreads ? std::max(1u, threads) : 1);
    return estimate;
}

} // namespace tetra
