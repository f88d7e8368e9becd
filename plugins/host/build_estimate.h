// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset.h"

#include <cstdint>

namespace tetra {

/// What a build's needs follow from.
struct BuildSize {
    DomainClass domain = DomainClass::RegularLattice;
    std::uint64_t points = 0;
    std::uint64_t tetrahedra = 0; ///< of irregular data
    SampleType type = SampleType::Float32;
    /// The share of the points that become sites when everything is kept. 1 is the worst case: noise.
    double siteShare = 1;
};

/// What building a model down to an error of 0 takes, by the builder that suits the data best. For its share of sites
/// within a factor of two of what was measured (docs/performance.md), the time on a processor of 2021.
struct BuildEstimate {
    std::uint64_t memoryBytes = 0; ///< at its peak, with the program and what it holds of the data
    std::uint64_t diskBytes = 0;   ///< at its peak, work files and model together
    std::uint64_t modelBytes = 0;
    double seconds = 0;
};

/// `threads`: that the build may use, positive.
BuildEstimate estimateBuild(const BuildSize& size, unsigned threads);

/// The size of a dataset, with the share of sites that a few thousand of its points let expect: those at which the
/// field bends. O(1) for lattices, in their memory or mapped file; other data are taken to need all points.
BuildSize buildSizeOf(const Dataset& dataset);

} // namespace tetra
