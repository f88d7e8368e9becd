// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_function.h"

namespace tetra {

/// The least distance of two values of the function that ParaView keeps in order: a billionth of the range.
double leastApart(const TransferFunction& function);

/// A function without a mask that looks as the one with it: what the mask hides has points of opacity 0. The mask's
/// largest value is still seen, so the step there is leastApart() above it.
TransferFunction withMaskAsSteps(const TransferFunction& function);

} // namespace tetra
