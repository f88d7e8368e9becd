// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/hdf5/helper/array_axes.h"

#include <tan/data.h>

#include <functional>
#include <optional>
#include <vector>

namespace tetra {

/// How stored numbers become values, as the file says: numbers * scale + offset by the attributes scale_factor and
/// add_offset; none where they are one of _FillValue or missing_value, or the fill value that the array was given, if
/// that is not 0. Parts that nobody wrote have the fill value.
struct StoredMeaning {
    bool isPacked = false;
    double scale = 1;
    double offset = 0;
    bool unpacksToFloat = false;        ///< else to double
    std::vector<long double> noValue{}; ///< stored numbers that stand for no value
    std::optional<Taken> fill{};        ///< what is told of all this
};

/// Errors (BadInput): nothing of the array was written, or a part without a fill value; a filter that is not there.
Result<StoredMeaning> storedMeaning(hid_t file, const Hdf5Array& array);

/// The type of samples without holes; of 64-bit integers the smaller of the two they may become.
SampleType sampleTypeOf(const StoredMeaning& meaning, const Hdf5Array& array, const ArrayPart& part);

struct ArraySamples {
    SampleType type = SampleType::Float32;
    Buffer<std::byte> samples{}; ///< NaN where there is no value
    std::vector<Message> remarks{};
};

/// Bytes of memory that reading a part takes, at most ~0.
std::uint64_t neededBytes(const Hdf5Array& array, const ArrayPart& part);

/// Reads a part of the array, in the order of its dimensions. Integers keep their type where there are no holes; those
/// of 64 bits become int32 if all fit, else double. `progress`: fractions. Errors: the library's.
Result<ArraySamples> readSamples(hid_t file, const Hdf5Array& array, const ArrayAxes& axes, const ArrayPart& part,
                                 const StoredMeaning& meaning, const std::function<void(double)>& progress);

} // namespace tetra
