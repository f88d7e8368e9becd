// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/curves/axes.h"

#include <algorithm>
#include <cmath>

namespace tetra {

bool hasPlaces(const TransferLimits& limits, ValueAxis axis) noexcept
{
    return axis == ValueAxis::Linear || limits.least > 0;
}

double placeOnAxis(double value, ValueAxis axis) noexcept
{
    return axis == ValueAxis::Linear ? value : std::log(value);
}

double valueOnAxis(double place, ValueAxis axis) noexcept
{
    return axis == ValueAxis::Linear ? place : std::exp(place);
}

TransferLimits placesOnAxis(const TransferLimits& values, ValueAxis axis) noexcept
{
    return {placeOnAxis(values.least, axis), placeOnAxis(values.largest, axis)};
}

TransferLimits valuesOnAxis(const TransferLimits& places, ValueAxis axis) noexcept
{
    return {valueOnAxis(places.least, axis), valueOnAxis(places.largest, axis)};
}

namespace {

/// One over the opacity about which the logarithmic axis goes over to a straight one.
constexpr double fineness = 1000;

double clampedShare(double number)
{
    return number > 0 ? std::min(number, 1.0) : 0;
}

} // namespace

double heightOf(double opacity, OpacityAxis axis) noexcept
{
    if (axis == OpacityAxis::Linear)
        return clampedShare(opacity);
    if (axis == OpacityAxis::SquareRoot)
        return std::sqrt(clampedShare(opacity));
    return clampedShare(std::log1p(fineness * clampedShare(opacity)) / std::log1p(fineness));
}

double opacityAtHeight(double height, OpacityAxis axis) noexcept
{
    if (axis == OpacityAxis::Linear)
        return clampedShare(height);
    if (axis == OpacityAxis::SquareRoot)
        return clampedShare(height) * clampedShare(height);
    return clampedShare(std::expm1(clampedShare(height) * std::log1p(fineness)) / fineness);
}

std::span<const double> opacityTicks(OpacityAxis axis) noexcept
{
    static constexpr double linear[] = {0, 0.25, 0.5, 0.75, 1}, squareRoot[] = {0, 0.1, 0.25, 0.5, 1},
                            logarithmic[] = {0, 0.001, 0.01, 0.1, 1};
    switch (axis) {
    case OpacityAxis::Linear: return linear;
    case OpacityAxis::SquareRoot: return squareRoot;
    case OpacityAxis::Logarithmic: return logarithmic;
    }
    return linear;
}

} // namespace tetra
