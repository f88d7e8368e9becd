// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tetra {

/// The smallest float that is not below `value`.
inline float roundedUp(double value)
{
    const float rounded = static_cast<float>(value);
    return static_cast<double>(rounded) < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
                                                : rounded;
}

/// The value of an IEEE 754 binary16, exactly.
constexpr float halfToFloat(std::uint16_t half) noexcept
{
    const std::uint32_t sign = (half & 0x8000u) << 16;
    const std::uint32_t magnitude = half & 0x7fffu;
    if (magnitude >= 0x7c00)
        return std::bit_cast<float>(sign | 0x7f800000u | (magnitude & 0x3ff) << 13);
    if (magnitude >= 0x0400)
        return std::bit_cast<float>(sign | ((magnitude << 13) + (112u << 23)));
    const float subnormal = static_cast<float>(magnitude) * 0x1p-24f;
    return sign != 0 ? -subnormal : subnormal;
}

/// The smallest half that is not less than `value`, which is not negative: an error bound stays a bound. Infinity
/// beyond the largest half, 65504; NaN gives infinity, too.
constexpr std::uint16_t halfRoundedUp(float value) noexcept
{
    constexpr std::uint32_t infinity = 0x7c00;
    if (!(value > 0))
        return value <= 0 ? 0 : infinity;
    if (value > 65504.0f)
        return infinity;
    if (value < 0x1p-14f) { // a subnormal half, or the smallest normal one: a multiple of 2^-24
        const float scaled = value * 0x1p24f;
        const auto floor = static_cast<std::uint16_t>(scaled);
        return static_cast<std::uint16_t>(floor + (static_cast<float>(floor) < scaled ? 1 : 0));
    }
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value) - (112u << 23);
    return static_cast<std::uint16_t>((bits + 0x1fffu) >> 13);
}

/// A bound on `amount / whole` as a half: its value times `whole` is not less than `amount`.
constexpr std::uint16_t halfBound(float amount, double whole) noexcept
{
    if (amount <= 0)
        return 0;
    std::uint16_t half = halfRoundedUp(static_cast<float>(amount / whole));
    // The division and the conversion to float may each have rounded down.
    while (static_cast<double>(halfToFloat(half)) * whole < static_cast<double>(amount))
        ++half;
    return half;
}

} // namespace tetra
