// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/widgets/curves/selection.h"

#include <tan/transfer.h>

namespace tetra {

/// A tent of opacities around a value.
struct OpacityPeak {
    double value = 0;
    double width = 0; ///< from foot to foot, in values
    double opacity = 1;
};

/// With a tent whose feet look as before, cut at the limits; what points were between the feet are gone. The colour of
/// the top is the one that was there. Selected are the feet and the top. A peak that is not finite, has no width or
/// lies outside of the limits changes nothing. O(points).
EditedSelection withPeak(const JoinedFunction& function, const OpacityPeak& peak, const TransferLimits& limits);

/// How much of a look may be lost: the largest difference, at any value.
struct LookTolerance {
    double colour = 1.0 / 255;  ///< of a channel
    double opacity = 1.0 / 255; ///< of the unit distance
};

/// The fewest points that look the same within the tolerance, of those that are there: what stays, stays as it is, and
/// only selected ones go. Selected is what is left of the selection. O(points^2) as a rule.
EditedSelection simplified(const JoinedFunction& function, const TransferSelection& selection,
                           const LookTolerance& tolerance);

/// Between each two neighbouring selected points as many points more that colour and extinction go with the logarithm
/// of the value, as ParaView's maps over log(value) do, nowhere farther from it than the tolerance. Selected are all of
/// them. The function stays one of straight pieces, which every back end draws exactly, so that this is an edit and no
/// kind of function of its own.
///
/// Over a factor r between two points, n pieces of equal factors q = r^(1/n) deviate by at most e(q) / n of the change,
/// e(q) = ln(x) / ln(q) - (x - 1) / (q - 1) with x = (q - 1) / ln(q); of an opacity not by more than of its optical
/// depth. Points whose values are not positive change nothing between them. O(points).
EditedSelection withLogarithmicCourse(const JoinedFunction& function, const TransferSelection& selection,
                                      const LookTolerance& tolerance);

} // namespace tetra
