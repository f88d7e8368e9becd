// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/analytic_points.h"

#include "core/base/portable_math.h"
#include "core/data/split_mix.h"

namespace tetra {

/// In [-1, 1) and a multiple of 2^-23: a float holds it, and a double the squares and their sums without rounding.
double ScatteredBall::nextCoordinate()
{
    state_ += splitMixStep;
    return static_cast<double>(splitMix(state_) >> 40) * 0x1p-23 - 1;
}

ScatteredPoint ScatteredBall::next()
{
    ScatteredPoint point;
    do {
        for (double& coordinate : point.position)
            coordinate = nextCoordinate();
    } while (point.position.squaredNorm() > 1);
    const double turns = 1.5 * point.position.squaredNorm() + point.position[2] / 2;
    point.value = (1 + portableCosineOfTurns(turns)) / 2;
    return point;
}

} // namespace tetra
