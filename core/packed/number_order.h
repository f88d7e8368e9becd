// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace tetra {

/// Numbers as the coders take them (PARTS.md, "order" and "difference"): close ones as close integers, with every bit.

/// An integer that rises with a number: of integers the distance from the least of their type, of floating-point
/// numbers their bits, all inverted if negative, else with the highest set.
template <class T> constexpr std::uint64_t orderOf(T number) noexcept
{
    if constexpr (std::is_integral_v<T>) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(number) -
                                          static_cast<std::int64_t>(std::numeric_limits<T>::min()));
    } else {
        using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
        const Bits bits = std::bit_cast<Bits>(number), sign = Bits(1) << (8 * sizeof(T) - 1);
        return (bits & sign) != 0 ? static_cast<Bits>(~bits) : static_cast<Bits>(bits | sign);
    }
}

/// The inverse; of an order that no number of the type has, its lowest bits.
template <class T> constexpr T numberOfOrder(std::uint64_t order) noexcept
{
    if constexpr (std::is_integral_v<T>) {
        return static_cast<T>(order + static_cast<std::uint64_t>(std::numeric_limits<T>::min()));
    } else {
        using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
        const Bits bits = static_cast<Bits>(order), sign = Bits(1) << (8 * sizeof(T) - 1);
        return std::bit_cast<T>((bits & sign) != 0 ? static_cast<Bits>(bits ^ sign) : static_cast<Bits>(~bits));
    }
}

/// The number of a type that is next to an expectation, halves of integers upwards: the sample that a mesh lets expect,
/// the coordinate that neighbours do. Of integers the least or the largest where it is beyond them. 0 where it is no
/// number, or no float: an extrapolation may be anything, and the bits of a NaN are not the same on every machine.
template <class T> T nearestNumber(double expected)
{
    if constexpr (std::is_integral_v<T>) {
        constexpr auto least = static_cast<double>(std::numeric_limits<T>::min());
        constexpr auto most = static_cast<double>(std::numeric_limits<T>::max());
        return expected >= least ? static_cast<T>(std::floor(std::min(expected, most - 0.5) + 0.5))
                                 : std::numeric_limits<T>::min();
    } else if constexpr (sizeof(T) == 4) {
        constexpr auto most = static_cast<double>(std::numeric_limits<float>::max());
        return std::abs(expected) <= most ? static_cast<float>(expected) : 0;
    } else {
        return std::isnan(expected) ? 0 : expected;
    }
}

/// The difference of two numbers of `bits` bits, modulo 2^bits; small ones of either sign as small numbers.
constexpr std::uint64_t zigzag(std::uint64_t number, std::uint64_t from, unsigned bits) noexcept
{
    const unsigned above = 64 - bits;
    const auto difference = static_cast<std::int64_t>((number - from) << above) >> above;
    return static_cast<std::uint64_t>(difference) << 1 ^ static_cast<std::uint64_t>(difference >> 63);
}

/// The inverse: the number.
constexpr std::uint64_t unzigzag(std::uint64_t code, std::uint64_t from, unsigned bits) noexcept
{
    const std::uint64_t difference = code >> 1 ^ (~(code & 1) + 1);
    return (from + difference) & ~std::uint64_t(0) >> (64 - bits);
}

} // namespace tetra
