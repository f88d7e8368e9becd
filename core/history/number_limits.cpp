// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/number_limits.h"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

namespace tetra {

namespace {

using format::Section;
using format::SectionId;

/// The numbers from `low` to `high`; NaN is never one of them.
template <class T> struct TypedLimits {
    T low{};
    T high{};
};

/// Those that a type has within limits of doubles; none if `low` is the larger one.
template <class T> TypedLimits<T> typedLimits(double low, double high)
{
    constexpr T least = std::numeric_limits<T>::lowest(), most = std::numeric_limits<T>::max();
    if (!(low <= static_cast<double>(most)) || !(high >= static_cast<double>(least)))
        return {most, least};
    return {low > static_cast<double>(least) ? static_cast<T>(low) : least,
            high < static_cast<double>(most) ? static_cast<T>(high) : most};
}

template <class T> bool liesWithin(T number, const TypedLimits<T>& limits)
{
    return number >= limits.low && number <= limits.high;
}

/// Whether all numbers are within limits that take turns, of which that of number `first` comes first. Many at a time:
/// the compiler makes vectors of them.
template <class T, std::size_t turns>
bool areWithin(std::span<const T> numbers, const std::array<TypedLimits<T>, turns>& limits, std::size_t first)
{
    constexpr std::size_t lanes = 16 * turns;
    std::array<T, lanes> low, high;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        low[lane] = limits[(first + lane) % turns].low;
        high[lane] = limits[(first + lane) % turns].high;
    }
    std::size_t at = 0;
    for (; at + lanes <= numbers.size(); at += lanes) {
        unsigned outside = 0;
        for (std::size_t lane = 0; lane < lanes; ++lane)
            outside |= static_cast<unsigned>(!(numbers[at + lane] >= low[lane])) |
                       static_cast<unsigned>(!(numbers[at + lane] <= high[lane]));
        if (outside != 0)
            return false;
    }
    for (; at < numbers.size(); ++at)
        if (!liesWithin(numbers[at], limits[(first + at) % turns]))
            return false;
    return true;
}

template <class T> std::span<const T> numbersIn(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
}

template <class T>
bool arePlaces(std::uint64_t offset, std::span<const std::byte> part, const std::array<double, 6>& box)
{
    std::array<TypedLimits<T>, 3> limits;
    for (std::size_t axis = 0; axis < 3; ++axis)
        limits[axis] = typedLimits<T>(box[axis], box[axis + 3]);
    return areWithin(numbersIn<T>(part), limits, static_cast<std::size_t>(offset / sizeof(T) % 3));
}

} // namespace

NumberLimits::NumberLimits(const Section& section, const format::Header& header) noexcept
    : range_(header.valueRange), box_(header.boundingBox)
{
    switch (static_cast<SectionId>(section.id)) {
    case SectionId::SiteValues:
    case SectionId::Samples:
        kind_ = Kind::Samples;
        type_ = static_cast<SampleType>(header.sampleType);
        break;
    case SectionId::SitePositions:
    case SectionId::SamplePositions:
        kind_ = Kind::Positions;
        numberBytes_ = section.elementBytes / 3;
        break;
    case SectionId::SiteRunningKeys:
    case SectionId::BatchErrors:
    case SectionId::BatchWarpings: kind_ = Kind::Bounds; break;
    case SectionId::OwnErrors:
    case SectionId::OwnWarpings: kind_ = Kind::Halves; break;
    case SectionId::SiteGroups: kind_ = Kind::Flags; break;
    default: break;
    }
}

bool NumberLimits::hold(std::uint64_t offset, std::span<const std::byte> part) const noexcept
{
    constexpr std::uint16_t infiniteHalf = 0x7c00; // negative ones and those that are not numbers lie above
    const auto lieBetween = [&]<class T>(T low, T high) {
        return areWithin(numbersIn<T>(part), std::array{TypedLimits<T>{low, high}}, 0);
    };
    switch (kind_) {
    case Kind::Samples:
        return visitSampleType(type_, [&]<class T>() {
            const TypedLimits<T> limits = typedLimits<T>(range_[0], range_[1]);
            return areWithin(numbersIn<T>(part), std::array{limits}, 0);
        });
    case Kind::Positions:
        return numberBytes_ == sizeof(float) ? arePlaces<float>(offset, part, box_)
                                             : arePlaces<double>(offset, part, box_);
    case Kind::Bounds: return lieBetween(0.0F, std::numeric_limits<float>::infinity());
    case Kind::Halves: return lieBetween(std::uint16_t(0), infiniteHalf);
    case Kind::Flags: return lieBetween(std::uint8_t(0), std::uint8_t(1));
    case Kind::None: break;
    }
    return true;
}

} // namespace tetra
