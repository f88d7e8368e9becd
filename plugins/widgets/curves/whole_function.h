// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/transfer.h>

namespace tetra {

/// Edits of a whole transfer function (R18), both curves and the mask; each keeps to its own points. Each edit of a
/// function that checkTransferFunction() accepts gives another one that it accepts. Where rounding brings more than two
/// points of a curve to one value, the first and the last stay. All O(points).

/// The values at which the function's curves begin and end; none without points.
std::optional<TransferLimits> extentOf(const TransferFunction& function);

/// What `value` looked like, value + by looks like. A shift that is not finite, or leads there, changes nothing.
TransferFunction shifted(const TransferFunction& function, double by);

/// What lies at a distance from the centre lies `factor` times as far from it. A factor that is not above zero, or
/// leads to values that are not finite, changes nothing.
TransferFunction widened(const TransferFunction& function, double centre, double factor);

/// Spread so that the first and the last point lie at the limits. Points of one value only stay.
TransferFunction spreadOver(const TransferFunction& function, const TransferLimits& limits);

/// What `value` looked like, limits.least + limits.largest - value looks like, but for the values of steps.
TransferFunction mirrored(const TransferFunction& function, const TransferLimits& limits);

/// All opacities times a factor, at most 1. A factor that is negative or not finite changes nothing.
TransferFunction withScaledOpacity(const TransferFunction& function, double factor);

/// Another unit distance, which changes all extinctions. Ignored unless it is positive.
TransferFunction withUnitDistance(const TransferFunction& function, double unitDistance);

/// With only values of the mask shown. One that is no range changes nothing.
TransferFunction withMask(const TransferFunction& function, const TransferMask& mask);
TransferFunction withoutMask(const TransferFunction& function);

} // namespace tetra
