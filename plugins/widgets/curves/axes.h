// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/transfer.h>

#include <cstdint>
#include <span>

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

/// How an editor's axis of opacities goes from 0, at height 0, to 1, at height 1.
enum class OpacityAxis : std::uint8_t {
    Linear,
    SquareRoot, ///< finer near zero: most of what clouds are made of is seen through
    Logarithmic ///< much finer near zero: log(1 + 1000 opacity), with a place for 0
};

/// In [0, 1]; opacities are cut to [0, 1], NaN counts as 0.
double heightOf(double opacity, OpacityAxis axis) noexcept;
/// The inverse; heights are cut to [0, 1].
double opacityAtHeight(double height, OpacityAxis axis) noexcept;

/// Opacities to be written beside the axis, ascending from 0 to 1.
std::span<const double> opacityTicks(OpacityAxis axis) noexcept;

} // namespace tetra
