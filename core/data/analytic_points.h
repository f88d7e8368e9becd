// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace tetra {

/// A scattered point, and the field there.
struct ScatteredPoint {
    Eigen::Vector3d position{0, 0, 0};
    double value = 0; ///< in [0, 1]
};

/// Random points, evenly spread over the unit ball, one after the other; the same bits on every machine for the same
/// seed. The field are waves that grow finer outwards, (1 + cos(2 pi (1.5 r^2 + z / 2))) / 2. The coordinates are
/// numbers of SplitMix64 (see whiteNoise()), three at a time until they fall into the ball.
class ScatteredBall {
public:
    explicit ScatteredBall(std::uint64_t seed) : state_(seed) {}
    ScatteredPoint next();

private:
    double nextCoordinate();

    std::uint64_t state_;
};

} // namespace tetra
