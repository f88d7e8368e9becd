// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/stored/stored_conversion.h"

#include "plugins/readers/lattice/headers/header_numbers.h"

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

/// Calls `use(point, number)` for every point, with the number that is its first one among those of the range. False
/// when cancelled. Points go along x first, or where their numbers lie far apart along x, through bricks that have few
/// points along x and along the axis of the nearest numbers: so the caches keep both what is read and what is written.
template <class Use> bool forEachPoint(const StoredVolume& volume, const Progress& progress, const Use& use)
{
    const auto& size = volume.lattice.size;
    const auto& strides = volume.strides;
    constexpr std::uint64_t brick = 16; // numbers of 4 bytes in a line of the caches
    const std::size_t near = strides[2] < strides[1] ? 2 : 1, far = 3 - near;
    const std::uint64_t columns = strides[0] <= strides[near] ? size[0] : brick;
    const std::array<std::uint64_t, 3> points{1, size[0], std::uint64_t(size[0]) * size[1]};
    const auto goThrough = [&](std::uint64_t firstX, std::uint64_t endX, std::uint64_t a, std::uint64_t firstB) {
        for (std::uint64_t b = firstB; b < std::min<std::uint64_t>(firstB + brick, size[near]); ++b) {
            std::uint64_t point = firstX + b * points[near] + a * points[far];
            std::uint64_t number = firstX * strides[0] + b * strides[near] + a * strides[far];
            for (std::uint64_t i = firstX; i < endX; ++i, number += strides[0])
                use(point++, number);
        }
    };
    for (std::uint64_t x = 0; x < size[0]; x += columns) {
        const std::uint64_t endX = std::min<std::uint64_t>(x + columns, size[0]);
        for (std::uint64_t a = 0; a < size[far]; ++a) {
            const double slabs = static_cast<double>(a) / size[far]; // of those with so many columns
            const double done = static_cast<double>(x) + static_cast<double>(endX - x) * slabs;
            progress.report(done / size[0], Message::marked("Reading"));
            for (std::uint64_t b = 0; b < size[near]; b += brick) {
                if (progress.cancelled())
                    return false;
                goThrough(x, endX, a, b);
            }
        }
    }
    return true;
}

/// The numbers of one type; `number` is the first one of a point.
template <class T> class Numbers {
public:
    Numbers(std::span<const std::byte> bytes, const StoredVolume& volume) : bytes_(bytes), volume_(volume) {}

    T at(std::uint64_t number) const { return numberAt<T>(bytes_, number * sizeof(T), volume_.order); }
    double scaled(std::uint64_t number) const
    {
        return static_cast<double>(at(number)) * volume_.slope + volume_.intercept;
    }
    double magnitude(std::uint64_t number) const
    {
        double sum = 0;
        for (std::uint32_t component = 0; component < volume_.components; ++component) {
            const double part = scaled(number + component * volume_.componentStride);
            sum += part * part;
        }
        return std::sqrt(sum);
    }

private:
    std::span<const std::byte> bytes_;
    const StoredVolume& volume_;
};

/// The narrowest type that holds all of these wide integers.
template <class T> Result<SampleType> typeOfAll(const Numbers<T>& numbers, const StoredVolume& volume,
                                                std::vector<Message>& remarks, const Progress& progress)
{
    T least = std::numeric_limits<T>::max(), most = std::numeric_limits<T>::lowest();
    bool isExact = true;
    const bool done = forEachPoint(volume, progress, [&](std::uint64_t, std::uint64_t number) {
        const T value = numbers.at(number);
        least = std::min(least, value);
        most = std::max(most, value);
        const auto near = static_cast<double>(value);
        constexpr double beyond = std::is_signed_v<T> ? 0x1p63 : 0x1p64;
        isExact = isExact && near < beyond && static_cast<T>(near) == value;
    });
    if (!done)
        return cancelledError(Message::marked("Reading"));
    if (std::in_range<std::int32_t>(least) && std::in_range<std::int32_t>(most))
        return SampleType::Int32;
    if (std::in_range<std::uint32_t>(least) && std::in_range<std::uint32_t>(most))
        return SampleType::UInt32;
    if (!isExact)
        remarks.push_back(
            Message::say("Its 64-bit integers were converted to floating-point numbers, which are exact to 53 bits."));
    return SampleType::Float64;
}

/// A field of `value(number)` of every point.
template <class Value>
Result<ScalarField> filled(const StoredVolume& volume, SampleType type, const Progress& progress, const Value& value)
{
    const std::uint64_t points = volume.lattice.pointCount();
    auto samples = allocateSamples(type, points);
    if (!samples)
        return samples.error();
    const bool done = visitSampleType(type, [&]<class To>() {
        To* to = reinterpret_cast<To*>(samples->get());
        return forEachPoint(volume, progress, [&](std::uint64_t point, std::uint64_t number) {
            to[point] = static_cast<To>(value(number));
        });
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
        return filled(volume, *known, progress, [&](std::uint64_t number) { return numbers.magnitude(number); });
    if (volume.isScaled() || std::is_same_v<T, Half>)
        return filled(volume, *known, progress, [&](std::uint64_t number) { return numbers.scaled(number); });
    if constexpr (std::is_integral_v<T> && sizeof(T) == sizeof(std::int64_t)) {
        const auto type = typeOfAll(numbers, volume, remarks, progress.part(0, 0.4));
        if (!type)
            return type.error();
        return filled(volume, *type, progress.part(0.4, 1), [&](std::uint64_t number) { return numbers.at(number); });
    } else if constexpr (!std::is_same_v<T, Half>) {
        return filled(volume, *known, progress, [&](std::uint64_t number) { return numbers.at(number); });
    }
    return Error{};
}

} // namespace

StoredRange rangeOf(const StoredVolume& volume)
{
    const std::uint64_t firstComponent = volume.component.value_or(0);
    const std::uint64_t lastComponent = volume.isMagnitude() ? volume.components - 1 : firstComponent;
    std::uint64_t lastPoint = volume.first;
    for (std::size_t axis = 0; axis < 3; ++axis)
        lastPoint += (volume.lattice.size[axis] - 1) * volume.strides[axis];
    return {volume.first + firstComponent * volume.componentStride,
            lastPoint + lastComponent * volume.componentStride + 1};
}

bool areSamples(const StoredVolume& volume)
{
    const auto& size = volume.lattice.size;
    return plainSampleType(volume.type) && !volume.isMagnitude() && !volume.isScaled() &&
           volume.strides == std::array<std::uint64_t, 3>{1, size[0], std::uint64_t(size[0]) * size[1]};
}

Result<ScalarField> samplesOfStored(std::span<const std::byte> bytes, const StoredVolume& volume,
                                    std::vector<Message>& remarks, const Progress& progress)
{
    return visitStoredType(volume.type, [&]<class T>() { return samplesOfType<T>(bytes, volume, remarks, progress); });
}

} // namespace tetra
