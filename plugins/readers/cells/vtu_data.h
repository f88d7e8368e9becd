// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/cells/vtu_head.h"

#include <tan/base.h>
#include <tan/data.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace tetra {

/// Exactly `count` numbers of an array, as doubles or, of whole numbers, as such. Memory is bounded by what the file
/// can hold of them: a count that it cannot hold is refused first. Errors name the array: another size, damaged or cut
/// short, not a number.
Result<std::vector<double>> readDoubles(const VtuHead& head, const VtuArray& array, std::uint64_t count);
/// Negative numbers become large ones.
Result<std::vector<std::uint64_t>> readIntegers(const VtuHead& head, const VtuArray& array, std::uint64_t count);

/// All numbers of an array, as many as the file says that it has.
Result<std::vector<std::uint64_t>> readAllIntegers(const VtuHead& head, const VtuArray& array);

/// The type of samples that holds an array's values; nothing if they are no numbers.
std::optional<SampleType> sampleTypeOf(const VtuArray& array);

} // namespace tetra
