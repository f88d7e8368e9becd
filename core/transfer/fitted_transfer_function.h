// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_function.h"
#include "core/transfer/value_histogram.h"

namespace tetra {

/// A transfer function to begin with for a field of which it is known how its values share the domain's volume. What
/// fills most of it, as the air around a scanned part or the undisturbed flow around a body, is transparent, rare
/// values are the more opaque, and light gets through on the whole; at equal shares, large values are more opaque than
/// small ones. Colours are those of sequentialTransferFunction(), closer where more is seen. `unitDistance` is a
/// fortieth of the domain's diagonal. Without a histogram it is sequentialTransferFunction(). O(parts).
TransferFunction fittedTransferFunction(const ValueHistogram& volumes, double unitDistance);

} // namespace tetra
