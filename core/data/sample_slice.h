// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// How a file holds the samples of a grid: one after the other, x fastest.
struct StoredSamples {
    std::array<std::uint32_t, 3> size{2, 2, 2};
    SampleType type = SampleType::UInt8;
    std::endian order = std::endian::native;
    std::uint64_t skippedBytes = 0; ///< before the first one
};

/// Samples of one layer of a grid, thinned out to a picture of it.
struct SampleSlice {
    std::uint32_t width = 0;  ///< along the first of the other two axes
    std::uint32_t height = 0; ///< along the second
    /// Row by row; NaN where the file ends before, or holds no number.
    std::vector<float> values;
    /// What most values lie in: without the hundredth of them at either end; both 0 if there are none.
    ValueRange window;
};

/// Layer `number` across axis `axis` (0 to 2) of the samples in `file`, which may be too short for them. At most `most`
/// points along each side are read, evenly spaced, and no other bytes: O(most^2). Errors: WrongUsage if there is no
/// such layer; cancelled.
TAN_INTERNAL Result<SampleSlice> readSampleSlice(std::span<const std::byte> file, const StoredSamples& samples,
                                                 int axis, std::uint32_t number, std::uint32_t most,
                                                 const Progress& progress = {});

} // namespace tetra
