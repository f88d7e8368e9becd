// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_editing.h"

#include <cstdint>

namespace tetra {

/// How an editor's axis of values goes.
enum class ValueAxis : std::uint8_t {
    Linear,
    Logarithmic ///< by the natural logarithm, where all values are positive: equal steps are equal factors
};

/// Whether all values between the limits have a place on the axis.
bool hasPlaces(const TransferLimits& limits, ValueAxis axis) noexcept;

/// A value on the axis: itself, or its logarithm.
double placeOnAxis(double value, ValueAxis axis) noexcept;
/// The inverse, within rounding.
double valueOnAxis(double place, ValueAxis axis) noexcept;

TransferLimits placesOnAxis(const TransferLimits& values, ValueAxis axis) noexcept;
TransferLimits valuesOnAxis(const TransferLimits& places, ValueAxis axis) noexcept;

} // namespace tetra
