// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset.h"
#include "core/model/section_writer.h"
#include "core/model/spooled_array.h"

#include <cstdint>

namespace tetra {

/// Writes the section of the sites' values; `points` are the sites' points in `dataset`.
Status writeSiteValues(SectionWriter& sections, const Dataset& dataset, const SpooledArray<std::uint32_t>& points);

/// The bytes of a position in a model of the dataset: none for a regular lattice, floats if they hold each coordinate
/// exactly, else doubles.
std::size_t positionBytes(const Dataset& dataset);

/// Writes the section of the sites' positions for a dataset that has positions: in floats if they hold each of its
/// coordinates exactly, else in doubles.
Status writeSitePositions(SectionWriter& sections, const Dataset& dataset, const SpooledArray<std::uint32_t>& points);

/// Writes the section of all points' positions, in the same numbers.
Status writeSamplePositions(SectionWriter& sections, const Dataset& dataset);

} // namespace tetra
