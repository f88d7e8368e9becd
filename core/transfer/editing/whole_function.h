// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_function.h"

namespace tetra {

/// Edits of the whole function and its mask, as by dragging in the picture; O(points). Of points that rounding brings
/// to one value the first and the last stay.

/// What `value` looked like, value + by looks like. A shift that is not finite, or leads there, changes nothing.
TransferFunction shifted(const TransferFunction& function, double by);

/// What lies at a distance from the centre lies `factor` times as far from it. A factor that is not above zero, or
/// leads to values that are not finite, changes nothing.
TransferFunction widened(const TransferFunction& function, double centre, double factor);

/// With only values of the mask shown. One that is no range changes nothing.
TransferFunction withMask(const TransferFunction& function, const TransferMask& mask);
TransferFunction withoutMask(const TransferFunction& function);

} // namespace tetra
