// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/editing/selection.h"

namespace tetra {

/// How much of a look may be lost: the largest difference, at any value.
struct LookTolerance {
    double colour = 1.0 / 255;  ///< of a channel
    double opacity = 1.0 / 255; ///< of the unit distance
};

/// The fewest points that look the same within the tolerance, of those that are there: what stays, stays as it is, and
/// only selected ones go. Selected is what is left of the selection. O(points^2) as a rule.
EditedSelection simplified(const TransferFunction& function, const TransferSelection& selection,
                           const LookTolerance& tolerance);

} // namespace tetra
