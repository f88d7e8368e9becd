// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_function.h"

#include <cstddef>
#include <optional>

namespace tetra {

/// What an editor does to a transfer function (R18), as values: each edit of a function that checkTransferFunction()
/// accepts gives another one that it accepts. A point is named by its index; one that does not exist changes nothing.
/// Points keep their groups; the mask stays but where the whole function is mirrored or spread. All O(points).

/// Values that points may be moved to.
struct TransferLimits {
    double least = 0;
    double largest = 1;
};

/// A function and which of its points the edit was about.
struct EditedTransfer {
    TransferFunction function;
    std::size_t point = 0;
};

/// With a point more, which changes nothing of how values look. None if two points have the value, or it is not finite.
std::optional<EditedTransfer> withPoint(const TransferFunction& function, double value);

TransferFunction withoutPoint(const TransferFunction& function, std::size_t point);

/// The point moved to a value and an opacity, as near to them as limits and its neighbours allow: it keeps a small
/// distance from those. Both sides of a step move along, but each has an opacity of its own.
TransferFunction withMovedPoint(const TransferFunction& function, std::size_t point, double value, double opacity,
                                const TransferLimits& limits);

TransferFunction withColour(const TransferFunction& function, std::size_t point, const std::array<float, 3>& colour);

/// The unit distance, and with it all that is seen, otherwise: lengths that are not above zero change nothing.
TransferFunction withUnitDistance(const TransferFunction& function, double unitDistance);

/// Whether the point is a side of a step.
bool isOnStep(const TransferFunction& function, std::size_t point);
/// The point made a step whose two sides look the same yet; named is the lower side. One that is a step stays as it is.
EditedTransfer withStep(const TransferFunction& function, std::size_t point);
/// The step made a point again, which looks as this side did.
EditedTransfer withoutStep(const TransferFunction& function, std::size_t point);

/// All opacities times a factor, at most 1. A factor that is negative or not finite changes nothing.
TransferFunction withScaledOpacity(const TransferFunction& function, double factor);

/// What `value` looked like, limits.least + limits.largest - value looks like, but for the values of steps. Of points
/// that rounding brings to one value the first and the last stay, here and in what follows.
TransferFunction mirrored(const TransferFunction& function, const TransferLimits& limits);

/// The points spread so that the first and the last lie at the limits. Points of one value only stay.
TransferFunction spreadOver(const TransferFunction& function, const TransferLimits& limits);

} // namespace tetra
