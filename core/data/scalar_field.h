// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"

#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

/// The type of a sample as it stands in a file and in memory. The numbers are part of the `.tan` format.
enum class SampleType : std::uint8_t {
    UInt8 = 0,
    Int8 = 1,
    UInt16 = 2,
    Int16 = 3,
    UInt32 = 4,
    Int32 = 5,
    Float32 = 6,
    Float64 = 7
};

constexpr std::size_t sampleSize(SampleType type) noexcept
{
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

constexpr bool isInteger(SampleType type) noexcept
{
    return type < SampleType::Float32;
}

/// The name that NRRD and the command line use: "uint8", "int16", "float", "double" ...
constexpr std::string_view sampleTypeName(SampleType type) noexcept
{
    constexpr std::string_view names[] = {"uint8", "int8", "uint16", "int16", "uint32", "int32", "float", "double"};
    return names[static_cast<std::size_t>(type)];
}

/// Calls `function.operator()<T>()` with the C++ type of `type` and returns what it returns.
template <class Function> decltype(auto) visitSampleType(SampleType type, Function&& function)
{
    switch (type) {
    case SampleType::UInt8: return function.template operator()<std::uint8_t>();
    case SampleType::Int8: return function.template operator()<std::int8_t>();
    case SampleType::UInt16: return function.template operator()<std::uint16_t>();
    case SampleType::Int16: return function.template operator()<std::int16_t>();
    case SampleType::UInt32: return function.template operator()<std::uint32_t>();
    case SampleType::Int32: return function.template operator()<std::int32_t>();
    case SampleType::Float32: return function.template operator()<float>();
    case SampleType::Float64: break;
    }
    return function.template operator()<double>();
}

/// Memory for `count` samples of `type`, to be filled and handed to a ScalarField. More than the machine's physical
/// memory is refused before anything is taken; so is a count whose bytes no 64-bit number holds.
Result<std::shared_ptr<std::byte>> allocateSamples(SampleType type, std::uint64_t count);

/// The smallest and the largest value of a field; errors in percent refer to `extent()` (R7).
struct ValueRange {
    double minimum = 0;
    double maximum = 0;
    double extent() const noexcept { return maximum - minimum; }
};

/// Samples of one type, shared and never changed: copying copies a pointer. Native byte order, naturally aligned.
/// Safe to read from any number of threads.
class ScalarField {
public:
    ScalarField() = default;
    /// `samples` holds at least `count` samples of `type` and keeps what it points into (an array, a mapped file)
    /// alive.
    ScalarField(SampleType type, std::uint64_t count, std::shared_ptr<const std::byte> samples);
    /// The same for samples that may take long to go through, as those of a mapped file do. Errors: cancelled.
    static Result<ScalarField> scanned(SampleType type, std::uint64_t count, std::shared_ptr<const std::byte> samples,
                                       const Progress& progress);

    SampleType type() const noexcept { return type_; }
    std::uint64_t count() const noexcept { return count_; }
    std::span<const std::byte> bytes() const noexcept { return {samples_.get(), count_ * sampleSize(type_)}; }

    /// The samples as T, which must be the type's own C++ type.
    template <class T> std::span<const T> as() const noexcept
    {
        assert(sizeof(T) == sampleSize(type_));
        return {reinterpret_cast<const T*>(samples_.get()), count_};
    }
    /// Any sample as a double, exactly. For a few values; loops over many use as<T>().
    double at(std::uint64_t index) const;
    /// Smallest and largest value, found once at construction.
    ValueRange range() const noexcept { return range_; }
    /// The number of samples that are NaN or infinite; they are left out of range().
    std::uint64_t notFiniteCount() const noexcept { return notFinite_; }

private:
    /// False when cancelled.
    bool findRange(const Progress& progress);

    SampleType type_ = SampleType::UInt8;
    std::uint64_t count_ = 0;
    std::uint64_t notFinite_ = 0;
    ValueRange range_;
    std::shared_ptr<const std::byte> samples_;
};

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
Result<SampleSlice> readSampleSlice(std::span<const std::byte> file, const StoredSamples& samples, int axis,
                                    std::uint32_t number, std::uint32_t most, const Progress& progress = {});

} // namespace tetra
