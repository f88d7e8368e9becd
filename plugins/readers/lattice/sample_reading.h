// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/sample_layout.h"

#include <tan/base.h>
#include <tan/data.h>

#include <cstddef>
#include <memory>
#include <span>

namespace tetra {

/// Reads the samples that `data` (all of a data file, or what follows a header) hold according to `layout`. Memory is
/// taken only once it is plain that there are enough data for it; none where they hold the samples as memory would and
/// `owner`, which keeps them alive, is given: then the field uses them where they are. Errors: too few or too many
/// data, with both numbers of bytes; damaged data; not enough memory; cancelled.
Result<ScalarField> readSamples(std::span<const std::byte> data, const SampleLayout& layout, const Progress& progress,
                                const std::shared_ptr<const void>& owner = nullptr);

/// The same, of the samples of this layout alone, into `samples`, which has exactly the room for them.
Status readSamplesInto(std::span<std::byte> samples, std::span<const std::byte> data, const SampleLayout& layout,
                       const Progress& progress);

/// The layout of each of so many files that have all samples among them, equally many each.
SampleLayout layoutOfEach(const SampleLayout& layout, std::uint64_t files);

/// The errors of readSamples() that show without going through the data: their number of bytes.
Status checkSampleBytes(std::span<const std::byte> data, const SampleLayout& layout);

} // namespace tetra
