// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/decimation/decimation_need.h"

#include "core/base/text.h"
#include "core/decimate/decimation.h"

#include <string>

namespace tetra {

DecimationSize decimationSize(const Dataset& dataset)
{
    if (dataset.domain == DomainClass::Irregular)
        return {dataset.pointCount(), dataset.tetrahedra ? dataset.tetrahedra->size() : 0};
    if (dataset.domain == DomainClass::Scattered)
        return {dataset.pointCount(), 0};
    DecimationSize size{dataset.lattice.pointCount(), gridCut(dataset.domain) == LatticeCut::Five ? 5u : 6u};
    for (const std::uint32_t points : dataset.lattice.size)
        size.tetrahedra *= points > 0 ? points - 1 : 0;
    return size;
}

std::uint64_t decimationNeed(const DecimationSize& size)
{
    // Positions, values and weights; the tetrahedra; and what the writer of the model keeps of each site and of the
    // tetrahedra that ever lived, of which there are some 17 a point.
    constexpr std::uint64_t inputBytesAPoint = 24 + 8 + 4, inputBytesATetrahedron = 16;
    constexpr std::uint64_t writerBytesAPoint = 4 + 17 * 4;
    return decimationBytes(size.points, size.tetrahedra) + size.points * (inputBytesAPoint + writerBytesAPoint) +
           size.tetrahedra * inputBytesATetrahedron;
}

namespace {

/// Of a grid as many as if it had a cell for each point.
double tetrahedraOf(const BuildSize& size)
{
    if (size.domain == DomainClass::Irregular)
        return static_cast<double>(size.tetrahedra);
    return static_cast<double>(size.points) * (gridCut(size.domain) == LatticeCut::Five ? 5 : 6);
}

} // namespace

BuildEstimate estimateDecimation(const BuildSize& size, double finest)
{
    // Of all that ever lived, with their sites; and how many these are for each one of the dataset.
    const bool isGrid = isOnLattice(size.domain);
    const double modelTetrahedronBytes = isGrid ? 21 : 26;
    const double livedOverKept = isGrid ? 2.7 : 3.5;
    constexpr double collapseSeconds = 60e-6;
    constexpr double fixedBytes = 30e6; // of memory: the program, and as decimationBytes()
    constexpr double pointBytes = 700;
    constexpr double tetrahedronBytes = 100;
    BuildEstimate estimate;
    const double tetrahedra = tetrahedraOf(size);
    const double whole = tetrahedra * livedOverKept * modelTetrahedronBytes;
    estimate.modelBytes = static_cast<std::uint64_t>(whole * (finest > 0 ? size.density.share(finest) : 1));
    estimate.diskBytes = estimate.modelBytes;
    estimate.memoryBytes = static_cast<std::uint64_t>(
        whole + fixedBytes + static_cast<double>(size.points) * pointBytes + tetrahedra * tetrahedronBytes);
    estimate.seconds = static_cast<double>(size.points) * collapseSeconds;
    return estimate;
}

Status checkDecimationNeed(const DecimationSize& size, std::uint64_t usableBytes)
{
    constexpr std::uint64_t mostPoints = 0xfffffffe, mostTetrahedra = (1ull << 30) - 1;
    const std::string mesh =
        std::to_string(size.points) + " points and " + std::to_string(size.tetrahedra) + " tetrahedra";
    if (size.points > mostPoints || size.tetrahedra > mostTetrahedra)
        return Error{ErrorKind::OutOfResource, "A mesh of " + mesh +
                                                   " is too large to be decimated: " + std::to_string(mostPoints) +
                                                   " points and " + std::to_string(mostTetrahedra) +
                                                   " tetrahedra are the most. Take a region of it or fewer samples."};
    const std::uint64_t need = decimationNeed(size);
    if (usableBytes == 0 || need <= usableBytes)
        return {};
    return Error{ErrorKind::OutOfResource,
                 "Decimation of " + mesh + " takes about " + neededBytesText(need) +
                     " of memory, and this machine has " + neededBytesText(usableBytes) +
                     ". Take a region of it or fewer samples, or, of a lattice or grid, refine it instead."};
}

} // namespace tetra
