// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/reserved_array.h"

#include <tan/base.h>
#include <tan/data.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace tetra {

Result<std::shared_ptr<std::byte>> allocateSamples(SampleType type, std::uint64_t count)
{
    const std::uint64_t physical = physicalBytes();
    const std::uint64_t limit = physical != 0 ? physical : std::numeric_limits<std::uint64_t>::max() / 2;
    if (count > limit / sampleSize(type))
        return Error{ErrorKind::OutOfResource,
                     Message::say("Not enough memory: %1 samples of type %2 do not fit into the %3 MiB of this "
                                  "machine. Use a smaller part or a coarser version of the data.",
                                  count, sampleTypeName(type), limit >> 20)};
    Result<std::shared_ptr<void>> memory = reserveMemory(count * sampleSize(type), Message::marked("the samples"));
    if (!memory)
        return memory.error();
    return std::static_pointer_cast<std::byte>(*std::move(memory));
}

namespace {

/// From one look at cancellation to the next: a slow disk reads as much in a second.
constexpr std::size_t samplesInPiece = std::size_t(1) << 23;

template <class T> struct Extremes {
    T minimum =
        std::numeric_limits<T>::has_infinity ? std::numeric_limits<T>::infinity() : std::numeric_limits<T>::max();
    T maximum =
        std::numeric_limits<T>::has_infinity ? -std::numeric_limits<T>::infinity() : std::numeric_limits<T>::lowest();
    std::uint64_t notFinite = 0;
};

template <class T> Extremes<T> extend(Extremes<T> extremes, std::span<const T> samples)
{
    for (const T sample : samples) {
        if constexpr (std::is_floating_point_v<T>)
            if (!std::isfinite(sample)) {
                ++extremes.notFinite;
                continue;
            }
        extremes.minimum = std::min(extremes.minimum, sample);
        extremes.maximum = std::max(extremes.maximum, sample);
    }
    return extremes;
}

template <class T> Extremes<T> joinedExtremes(const Extremes<T>& a, const Extremes<T>& b)
{
    return {std::min(a.minimum, b.minimum), std::max(a.maximum, b.maximum), a.notFinite + b.notFinite};
}

template <class T> Extremes<T> extremesOf(std::span<const T> samples)
{
    using Part = tbb::blocked_range<std::size_t>;
    return tbb::parallel_reduce(
        Part(0, samples.size(), std::size_t(1) << 16), Extremes<T>{},
        [&](const Part& part, const Extremes<T>& before) {
            return extend(before, samples.subspan(part.begin(), part.size()));
        },
        joinedExtremes<T>);
}

} // namespace

ScalarField::ScalarField(SampleType type, std::uint64_t count, std::shared_ptr<const std::byte> samples)
    : type_(type), count_(count), samples_(std::move(samples))
{
    findRange({});
}

Result<ScalarField> ScalarField::scanned(SampleType type, std::uint64_t count, std::shared_ptr<const std::byte> samples,
                                         const Progress& progress)
{
    ScalarField field;
    field.type_ = type;
    field.count_ = count;
    field.samples_ = std::move(samples);
    if (!field.findRange(progress))
        return cancelledError(Message::marked("Reading"));
    return field;
}

ScalarField ScalarField::ofKnownRange(SampleType type, std::uint64_t count, std::shared_ptr<const std::byte> samples,
                                      const ValueRange& range)
{
    ScalarField field;
    field.type_ = type;
    field.count_ = count;
    field.samples_ = std::move(samples);
    field.range_ = range;
    return field;
}

bool ScalarField::findRange(const Progress& progress)
{
    return visitSampleType(type_, [&]<class T>() {
        const std::span<const T> samples = as<T>();
        Extremes<T> extremes;
        for (std::size_t begin = 0; begin < samples.size(); begin += samplesInPiece) {
            if (progress.cancelled())
                return false;
            const auto piece = samples.subspan(begin, std::min(samplesInPiece, samples.size() - begin));
            extremes = joinedExtremes(extremes, extremesOf(piece));
            progress.report(static_cast<double>(begin + piece.size()) / static_cast<double>(count_),
                            Message::marked("Reading"));
        }
        notFinite_ = extremes.notFinite;
        if (notFinite_ < count_)
            range_ = {static_cast<double>(extremes.minimum), static_cast<double>(extremes.maximum)};
        return true;
    });
}

double ScalarField::at(std::uint64_t index) const
{
    return visitSampleType(type_, [&]<class T>() { return static_cast<double>(as<T>()[index]); });
}

} // namespace tetra
