// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/lattice.h"
#include "core/model/exact_cell.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tetra {

/// Calls function(place, sample, weights) for every lattice point in the closed cell, row by row: weights are six
/// volumes times its barycentric coordinates, exact. The cell is positive.
template <class Function> void forEachSample(const Lattice& lattice, const CellCorners& corners, Function&& function)
{
    const BarycentricPlanes planes(corners);
    LatticePoint low = corners[0];
    LatticePoint high = corners[0];
    for (const LatticePoint& corner : corners)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], corner[axis]);
            high[axis] = std::max(high[axis], corner[axis]);
        }
    for (std::int64_t k = low[2]; k <= high[2]; ++k)
        for (std::int64_t j = low[1]; j <= high[1]; ++j) {
            const BarycentricRow row = planes.row({low[0], j, k});
            std::array<std::int64_t, 4> weights = row.start;
            std::uint64_t sample = lattice.index(static_cast<std::uint32_t>(low[0]), static_cast<std::uint32_t>(j),
                                                 static_cast<std::uint32_t>(k));
            for (std::int64_t i = low[0]; i <= high[0]; ++i, ++sample) {
                if ((weights[0] | weights[1] | weights[2] | weights[3]) >= 0)
                    function(LatticePoint{i, j, k}, sample, weights);
                for (int corner = 0; corner < 4; ++corner)
                    weights[corner] += row.step[corner];
            }
        }
}

} // namespace tetra
