// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/graphics/sight/sight_line.h"

#include <vector>

namespace tetra {

/// A piece of a line of sight in which value and extinction go in a straight line from one end to the other: what a ray
/// has of a cell and of a segment of the transfer function.
struct SightSlab {
    SightPart part;
    double valueAtStart = 0;
    double valueAtEnd = 0;
    double extinctionAtStart = 0; ///< per unit of length of the dataset
    double extinctionAtEnd = 0;
};

/// All of a volume within `part`, the nearest first, those that nothing is seen of left out. O(cells), and a logarithm
/// for each that is met. What was found so far if cancelled.
std::vector<SightSlab> slabsAlong(const Volume& volume, const SightLine& line, const SightPart& part,
                                  const Progress& progress = {});

} // namespace tetra
