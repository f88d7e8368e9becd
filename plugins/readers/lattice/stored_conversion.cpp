// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/stored_conversion.h"

#include "plugins/readers/lattice/header_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace tetra {

namespace {

/// A number of IEEE 754's half precision, which a float holds exactly.
struct Half {
    std::uint16_t bits = 0;

    explicit operator double() const
    {
        constexpr int bitsOfFraction = 10, bias = 15;
        const int exponent = bits >> bitsOfFraction & 31;
        const int fraction = bits & 1023;
        double size = exponent == 31  ? (fraction == 0 ? std::numeric_limits<double>::infinity()
                                                       : std::numeric_limits<double>::quiet_NaN())
                      : exponent == 0 ? std::ldexp(fraction, 1 - bias - bitsOfFraction)
                                      : std::ldexp(fraction + 1024, exponent - bias - bitsOfFraction);
        return bits >> 15 != 0 ? -size : size;
    }
};

/// Calls `function.operator()<T>()` with the type of the numbers as they stand in a file.
template <class Function> decltype(auto) visitStoredType(StoredType type, Function&& function)
{
    switch (type) {
    case StoredType::Int64: return function.template operator()<std::int64_t>();
    case StoredType::UInt64: return function.template operator()<std::uint64_t>();
    case StoredType::Float16: return function.template operator()<Half>();
    default: return visitSampleType(static_cast<SampleType>(type), function);
    }
}

/// Calls `use(point)` for every point. False when cancelled.
template <class Use> bool forEachPoint(std::uint64_t points, const Progress& progress, const Use& use)
{
    constexpr std::uint64_t step = 1 << 20;
    for (std::uint64_t begin = 0; begin < points; begin += step) {
        if (progress.cancelled())
            return false;
        for (std::uint64_t point = begin; point < std::min(points, begin + step); ++point)
            use(point);
        progress.report(static_cast<double>(begin) / static_cast<double>(points), Message::marked("Reading"));
    }
    return true;
}

/// The numbers of one type, by point and component.
template <class T> class Numbers {
public:
    Numbers(std::span<const std::byte> bytes, const StoredVolume& volume)
        : bytes_(bytes), volume_(volume), begin_(volume.first - rangeOf(volume).begin)
    {
    }

    T at(std::uint64_t point, std::uint32_t component) const
    {
        const std::uint64_t number = begin_ + point * volume_.pointStride + component * volume_.componentStride;
        return numberAt<T>(bytes_, number * sizeof(T), volume_.order);
    }
    /// The one of the chosen component.
    T chosen(std::uint64_t point) const { return at(point, volume_.component.value_or(0)); }
    double scaled(std::uint64_t point, std::uint32_t component) const
    {
        return static_cast<double>(at(point, component)) * volume_.slope + volume_.intercept;
    }
    double magnitude(std::uint64_t point) const
    {
        double sum = 0;
        for (std::uint32_t component = 0; component < volume_.components; ++component) {
            const double part = scaled(point, component);
            sum += part * part;
        }
        return std::sqrt(sum);
    }

private:
    std::span<const std::byte> bytes_;
    const StoredVolume& volume_;
    std::uint64_t begin_; ///< of the first number of the samples among these, modulo 2^64
};

/// The narrowest type that holds all of these wide integers.
template <class T> Result<SampleType> typeOfAll(const Numbers<T>& numbers, std::uint64_t points,
                                                std::vector<Message>& remarks, const Progress& progress)
{
    T least = std::numeric_limits<T>::max(), most = std::numeric_limits<T>::lowest();
    bool isExact = true;
    const bool done = forEachPoint(points, progress, [&](std::uint64_t point) {
        const T value = numbers.chosen(point);
        least = std::min(least, value);
        most = std::max(most, value);
        const auto near = static_cast<double>(value);
        isExact = isExact && near < 0x1p63 && static_cast<T>(near) == value;
    });
    if (!done)
        return cancelledError(Message::marked("Reading"));
    if (std::in_range<std::int32_t>(least) && std::in_range<std::int32_t>(most))
        return SampleType::Int32;
    if (std::in_range<std::uint32_t>(least) && std::in_range<std::uint32_t>(most))
        return SampleType::UInt32;
    if (!isExact)
        remarks.push_back(Message::say("Its 64-bit integers became floating-point numbers of 53 bits."));
    return SampleType::Float64;
}

template <class Value>
Result<ScalarField> filled(const StoredVolume& volume, SampleType type, const Progress& progress, const Value& value)
{
    const std::uint64_t points = volume.lattice.pointCount();
    auto samples = allocateSamples(type, points);
    if (!samples)
        return samples.error();
    const bool done = visitSampleType(type, [&]<class To>() {
        To* to = reinterpret_cast<To*>(samples->get());
        return forEachPoint(points, progress, [&](std::uint64_t point) { to[point] = static_cast<To>(value(point)); });
    });
    if (!done)
        return cancelledError(Message::marked("Reading"));
    return ScalarField(type, points, *std::move(samples));
}

template <class T> Result<ScalarField> samplesOfType(std::span<const std::byte> bytes, const StoredVolume& volume,
                                                     std::vector<Message>& remarks, const Progress& progress)
{
    const Numbers<T> numbers(bytes, volume);
    const auto known = storedSampleType(volume);
    if (volume.isMagnitude())
        return filled(volume, *known, progress, [&](std::uint64_t point) { return numbers.magnitude(point); });
    if (volume.isScaled())
        return filled(volume, *known, progress,
                      [&](std::uint64_t point) { return numbers.scaled(point, volume.component.value_or(0)); });
    if constexpr (std::is_same_v<T, Half>) {
        return filled(volume, *known, progress,
                      [&](std::uint64_t point) { return static_cast<double>(numbers.chosen(point)); });
    } else if constexpr (std::is_integral_v<T> && sizeof(T) == sizeof(std::int64_t)) {
        const auto type = typeOfAll(numbers, volume.lattice.pointCount(), remarks, progress.part(0, 0.4));
        if (!type)
            return type.error();
        return filled(volume, *type, progress.part(0.4, 1), [&](std::uint64_t point) { return numbers.chosen(point); });
    } else {
        return filled(volume, *known, progress, [&](std::uint64_t point) { return numbers.chosen(point); });
    }
}

} // namespace

StoredRange rangeOf(const StoredVolume& volume)
{
    const std::uint64_t firstComponent = volume.component.value_or(0);
    const std::uint64_t lastComponent = volume.isMagnitude() ? volume.components - 1 : firstComponent;
    return {volume.first + firstComponent * volume.componentStride,
            volume.first + (volume.lattice.pointCount() - 1) * volume.pointStride +
                lastComponent * volume.componentStride + 1};
}

bool areSamples(const StoredVolume& volume)
{
    return plainSampleType(volume.type) && !volume.isMagnitude() && !volume.isScaled() && volume.pointStride == 1;
}

Result<ScalarField> samplesOfStored(std::span<const std::byte> bytes, const StoredVolume& volume,
                                    std::vector<Message>& remarks, const Progress& progress)
{
    return visitStoredType(volume.type, [&]<class T>() { return samplesOfType<T>(bytes, volume, remarks, progress); });
}

} // namespace tetra
