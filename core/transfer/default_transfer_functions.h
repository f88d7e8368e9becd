// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_function.h"

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

} // namespace tetra
