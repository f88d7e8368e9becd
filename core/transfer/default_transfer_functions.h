// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_function.h"
#include "core/transfer/value_histogram.h"

namespace tetra {

/// Transfer functions to begin with, for values in [smallest, largest]; the colours can be told apart also by people
/// who do not see red or green as others do. `unitDistance` is usually a fortieth of the domain's diagonal. If the
/// range is empty or not finite, all values look the same.

/// Dark blue over green to yellow, darkest where the value is small, opacity rising with the value: after the colour
/// map viridis by N. Smith and S. van der Walt (CC0).
TransferFunction sequentialTransferFunction(double smallest, double largest, double unitDistance);

/// Blue over a pale middle to orange, opaque at both ends: for values that deviate to two sides. After the colours blue
/// and vermilion of Okabe and Ito (2008).
TransferFunction divergingTransferFunction(double smallest, double largest, double unitDistance);

/// A transfer function to begin with for a field of which it is known how its values share the domain's volume. What
/// fills most of it, as the air around a scanned part or the undisturbed flow around a body, is transparent, rare
/// values are the more opaque, and light gets through on the whole; at equal shares, large values are more opaque than
/// small ones. Colours are those of sequentialTransferFunction(), closer where more is seen. `unitDistance` is a
/// fortieth of the domain's diagonal. Without a histogram it is sequentialTransferFunction(). O(parts).
TransferFunction fittedTransferFunction(const ValueHistogram& volumes, double unitDistance);

} // namespace tetra
