// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/sample_scan.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The slots that scanSamples() has to look at: in floats, sixteen rows of samples at a time, so that what lies
/// close to a face or to its limit counts as in and beyond. None is left out that has a sample beyond its limit. No
/// sample is farther from 0 than `reach`. Where the machine has no vectors for that, all are suspects.
struct FilteredTetrahedra {
    std::vector<std::uint32_t> suspects;
    std::vector<std::uint32_t> fine; ///< some of the others: none of their samples is beyond the least limit
};
void filterTetrahedra(const LocalDelaunay& mesh, std::span<const std::uint32_t> slots, const LatticeSamples& samples,
                      double reach, const ErrorLimits& limits, ScannedPart part, FilteredTetrahedra& filtered);

} // namespace tetra
