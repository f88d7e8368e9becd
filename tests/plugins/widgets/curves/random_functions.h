// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/widgets/curves/selection.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace tetra {

/// Of the functions made here.
inline constexpr TransferLimits randomLimits{-10, 10};

/// Up to 11 points of whole values within the limits, some of them steps, groups and a mask now and then. Opacities are
/// multiples of 1/256 below 1.
inline JoinedFunction randomFunction(std::mt19937& random)
{
    std::uniform_real_distribution<float> unit(0, 1);
    JoinedFunction function;
    function.unitDistance = 0.1 + double(unit(random));
    for (auto count = random() % 12; count > 0; --count) {
        const double value = std::round(20 * double(unit(random))) - 10;
        if (std::ranges::count(function.points, value, &TransferPoint::value) >= 2)
            continue;
        const float opacity = std::floor(256 * unit(random)) / 257;
        function.points.push_back({value, {unit(random), unit(random), unit(random)}, opacity});
        if (random() % 2 == 0)
            function.points.back().group = int(random() % 10);
    }
    std::ranges::stable_sort(function.points, {}, &TransferPoint::value);
    if (random() % 3 == 0) {
        const double least = std::round(20 * double(unit(random))) - 10;
        function.mask = TransferMask{least, least + double(random() % 8)};
    }
    return function;
}

/// The same of a function whose curves have points of their own.
inline TransferFunction randomCurves(std::mt19937& random)
{
    TransferFunction function = separated(randomFunction(random));
    function.colours = separated(randomFunction(random)).colours;
    return function;
}

inline TransferSelection randomSelection(std::mt19937& random, const JoinedFunction& function)
{
    TransferSelection selection;
    for (std::size_t i = 0; i < function.points.size(); ++i)
        if (random() % 2 == 0)
            selection.push_back(i);
    return selection;
}

inline double opacityOf(const TransferFunction& function, const TransferSample& look)
{
    return -std::expm1(-look.extinction * function.unitDistance);
}

/// The largest difference of opacity, and of colour if wanted, that values from -13 to 13 show, at no whole or half
/// value and whatever the masks are.
inline double largestDifference(const TransferFunction& a, const TransferFunction& b, bool colours = true)
{
    double largest = 0;
    for (double value = -12.97; value < 13; value += 0.04) {
        const TransferSample one = evaluateUnmasked(a, value), other = evaluateUnmasked(b, value);
        largest = std::max(largest, std::abs(opacityOf(a, one) - opacityOf(b, other)));
        for (std::size_t channel = 0; colours && channel < 3; ++channel)
            largest = std::max(largest, std::abs(one.colour[channel] - other.colour[channel]));
    }
    return largest;
}

inline double largestDifference(const JoinedFunction& a, const JoinedFunction& b, bool colours = true)
{
    return largestDifference(separated(a), separated(b), colours);
}

} // namespace tetra
