// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/build_estimate.h"

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

constexpr double mostPointsAsWhole = 1 << 22; // as the refinement chooses blocks

Costs costsOf(const BuildSize& size)
{
    const auto points = static_cast<double>(size.points);
    if (size.domain == DomainClass::Scattered)
        return {.pointBytes = 60, .siteBytes = 700, .modelSiteBytes = 440, .siteSeconds = 25e-6};
    if (size.domain == DomainClass::Curvilinear)
        return {.pointBytes = 60, .siteBytes = 600, .modelSiteBytes = 340, .siteSeconds = 7e-6};
    if (points > mostPointsAsWhole)
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

BuildEstimate estimateDecimation(const BuildSize& size)
{
    constexpr double modelTetrahedronBytes = 26; // all that ever lived, with their sites
    constexpr double livedOverKept = 3.5;        // tetrahedra of the history over those of the dataset
    constexpr double collapseSeconds = 12e-6;
    constexpr double fixedBytes = 30e6; // of memory: the program, and as decimationBytes()
    constexpr double pointBytes = 700;
    constexpr double tetrahedronBytes = 100;
    BuildEstimate estimate;
    const auto tetrahedra = static_cast<double>(size.tetrahedra);
    estimate.modelBytes = static_cast<std::uint64_t>(tetrahedra * livedOverKept * modelTetrahedronBytes);
    estimate.diskBytes = estimate.modelBytes;
    estimate.memoryBytes =
        estimate.modelBytes + static_cast<std::uint64_t>(fixedBytes + static_cast<double>(size.points) * pointBytes +
                                                         tetrahedra * tetrahedronBytes);
    estimate.seconds = static_cast<double>(size.points) * collapseSeconds;
    return estimate;
}

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

BuildEstimate estimateBuild(const BuildSize& size, unsigned threads)
{
    if (size.domain == DomainClass::Irregular)
        return estimateDecimation(size);
    const Costs costs = costsOf(size);
    const auto points = static_cast<double>(size.points);
    const double sites = std::max(points * size.siteShare, 8.0);
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

} // namespace tetra
