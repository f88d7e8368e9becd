// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/editing/value_axis.h"

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

} // namespace tetra
