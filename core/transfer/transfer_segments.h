// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_function.h"

#include <vector>

namespace tetra {

/// A range of values, [begin, end), in which colour and extinction are affine:
/// atOrigin + (value - origin) * perValue.
struct TransferSegment {
    double begin = 0; ///< minus infinity for the first
    double end = 0;   ///< infinity for the last
    double origin = 0;
    TransferSample atOrigin;
    TransferSample perValue;

    /// Nothing of these values is seen.
    bool transparent() const noexcept { return atOrigin.extinction == 0 && perValue.extinction == 0; }
};

/// The segments between the knots of a function that checkTransferFunction() accepts, from minus to plus infinity; one
/// transparent segment if it has no points, and one each for what lies to the sides of its mask. O(points).
std::vector<TransferSegment> transferSegments(const TransferFunction& function);

} // namespace tetra
