// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/half.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace tetra {

/// Errors of linear interpolation in a cell, comparable with what a model claims. Weights are six volumes times
/// barycentric coordinates.
///
/// Integer samples: everything is a numerator over the cell's six volumes, an integer, and no rounding happens.
/// 8 and 16 bits: below 2^40 * 2^17 * 4, fits 64 bits; 32 bits need 128.
template <class Sample> struct ExactError {
    using Wide = __int128;
    using Number = std::conditional_t<sizeof(Sample) <= 2, std::int64_t, Wide>;

    static Number at(const std::array<std::int64_t, 4>& weights, const std::array<Sample, 4>& corners, Sample sample,
                     std::int64_t /*sixVolumes*/)
    {
        Number sum = 0;
        for (int i = 0; i < 4; ++i)
            sum += static_cast<Number>(weights[i]) * (static_cast<Number>(corners[i]) - static_cast<Number>(sample));
        return sum < 0 ? -sum : sum;
    }

    /// The largest number that is at most `claimed`, in units of the values.
    static Number claimedBound(double claimed, double /*extent*/, std::int64_t sixVolumes)
    {
        constexpr int digits = std::numeric_limits<double>::digits;
        if (!(claimed > 0))
            return 0;
        if (std::isinf(claimed))
            return largest();
        int exponent = 0;
        const double fraction = std::frexp(claimed, &exponent);
        return scaled(static_cast<Wide>(std::ldexp(fraction, digits)) * sixVolumes, exponent - digits);
    }

    /// The largest number that is at most `half` as a fraction of the value range.
    static Number ownBound(std::uint16_t half, double extent, std::int64_t sixVolumes)
    {
        if (half >= 0x7c00)
            return largest();
        const auto fraction = static_cast<std::int64_t>(std::ldexp(halfToFloat(half), 24)); // below 2^40
        return scaled(static_cast<Wide>(fraction) * static_cast<std::int64_t>(extent) * sixVolumes, -24);
    }

    static double inUnitsOfValues(Number error, std::int64_t sixVolumes)
    {
        return static_cast<double>(error) / static_cast<double>(sixVolumes);
    }

private:
    static constexpr Number largest()
    {
        return static_cast<Number>(
            (static_cast<std::conditional_t<sizeof(Number) == 8, std::uint64_t, unsigned __int128>>(0) - 1) / 2);
    }
    /// floor(number * 2^exponent), or the largest Number if that is too large. `number` is below 2^110.
    static Number scaled(Wide number, int exponent)
    {
        if (number <= 0)
            return 0;
        if (exponent < 0)
            number = exponent <= -127 ? 0 : number >> -exponent;
        else if (exponent > 60 || number >> (126 - exponent) != 0)
            return largest();
        else
            number <<= exponent;
        return number > static_cast<Wide>(largest()) ? largest() : static_cast<Number>(number);
    }
};

/// Errors in units of the values, for what no integer holds: floating-point samples and weighted errors (R6). The
/// interpolation and the product with the weight round, in the builder as here, by a few 1e-16 of the range; a claim is
/// kept if it is exceeded by no more than 1e-12 of the range.
template <class Sample> struct RoundedError {
    using Number = double;
    static constexpr double allowance = 1e-12;

    static Number at(const std::array<std::int64_t, 4>& weights, const std::array<Sample, 4>& corners, Sample sample,
                     std::int64_t sixVolumes)
    {
        Number sum = 0;
        for (int i = 0; i < 4; ++i)
            sum += static_cast<double>(weights[i]) / static_cast<double>(sixVolumes) *
                   (static_cast<double>(corners[i]) - static_cast<double>(sample));
        return std::abs(sum);
    }
    static Number claimedBound(double claimed, double extent, std::int64_t /*sixVolumes*/)
    {
        return claimed + allowance * extent;
    }
    static Number ownBound(std::uint16_t half, double extent, std::int64_t /*sixVolumes*/)
    {
        return static_cast<double>(halfToFloat(half)) * extent + allowance * extent;
    }
    static double inUnitsOfValues(Number error, std::int64_t /*sixVolumes*/) { return error; }
};

template <std::floating_point Sample> struct ExactError<Sample> : RoundedError<Sample> {
};

} // namespace tetra
