// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

#include <tan/base.h>
#include <tan/data.h>

#include <cstddef>
#include <span>
#include <vector>

namespace tetra {

/// The numbers of the samples that were chosen: all from the first to the last of them, [begin, end) of those of the
/// files.
struct StoredRange {
    std::uint64_t begin = 0, end = 0;
};
StoredRange rangeOf(const StoredVolume& volume);

/// Whether the bytes of that range, in the byte order of this machine, are the samples themselves.
bool areSamples(const StoredVolume& volume);

/// Makes samples of the bytes of that range, which have the byte order of the volume: takes the component, scales, puts
/// them in the order of the lattice, and changes the type if TAn has none like it. A remark tells what is lost. Linear,
/// cancellable. Errors: cancelled; not enough memory.
Result<ScalarField> samplesOfStored(std::span<const std::byte> bytes, const StoredVolume& volume,
                                    std::vector<Message>& remarks, const Progress& progress);

} // namespace tetra
