// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/process/reading_program.h"
#include "plugins/readers/zarr/helper/zarr_copying.h"

#include <tan/base.h>
#include <tan/data.h>

#include <cstdint>
#include <vector>

namespace tetra {

/// The samples of a volume, x running fastest.
struct ZarrSamples {
    SampleType type = SampleType::Float32;
    Buffer<std::byte> samples{};
    std::vector<Message> remarks{}; ///< on chunks that nobody wrote, and numbers that were rounded
};

/// Reads the chunks of a selection, in their order. Limits the work of this process to what such an array needs.
/// Errors, sentences about "it", the folder: chunks that are damaged, or of another size; none of them is there. May
/// throw std::bad_alloc.
Result<ZarrSamples> readZarrSamples(const ZarrFolder& folder, ZarrArray array, const ZarrSelection& selection,
                                    const TellProgress& progress);

} // namespace tetra
