// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/editing/selection.h"

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
EditedSelection withPeak(const TransferFunction& function, const OpacityPeak& peak, const TransferLimits& limits);

} // namespace tetra
