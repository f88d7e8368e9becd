// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/picking/picking.h"
#include "core/render/samples/sampled_field.h"

#include <vector>

namespace tetra {

/// A piece of a line of sight through samples, in which the value goes in a straight line.
struct SampledPiece {
    PickingInterval part;
    double valueAtStart = 0;
    double valueAtEnd = 0;
};

/// The line within `part` and the lattice, the nearest first, four pieces a cell. O(pieces).
std::vector<SampledPiece> sampledPieces(const SampledField& field, const PickingRay& line, const PickingInterval& part);

} // namespace tetra
