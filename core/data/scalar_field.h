// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/sample_type.h"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace tetra {

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

} // namespace tetra
