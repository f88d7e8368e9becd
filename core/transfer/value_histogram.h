// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// How many values lie in each of some equal parts of a range.
struct ValueHistogram {
    double least = 0;
    double largest = 0;
    std::vector<std::uint64_t> counts; ///< from the least values to the largest

    std::uint64_t highest() const noexcept;
};

/// The largest value counts as of the last part; values outside of [least, largest] and NaN are not counted. No counts
/// if the range is not finite or `parts` is not above zero; all in the first part if the range has no extent.
/// O(values).
ValueHistogram valueHistogram(std::span<const float> values, double least, double largest, int parts);

/// The same over the natural logarithms of values: `least` and `largest` are values, those of the histogram logarithms.
/// No counts if `least` is not above zero. O(values).
ValueHistogram logarithmicHistogram(std::span<const float> values, double least, double largest, int parts);

/// The height of a bar, in [0, 1] of the highest: linear, or logarithmic so that rare values are seen, too.
double barHeight(std::uint64_t count, std::uint64_t highest, bool logarithmic) noexcept;

} // namespace tetra
