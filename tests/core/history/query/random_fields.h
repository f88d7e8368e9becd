// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/query.h>

#include <cmath>
#include <random>

namespace tetra {

/// Near the origin, of whole numbers or not.
inline Region randomRegion(std::mt19937& random)
{
    const bool whole = random() % 2 == 0;
    std::uniform_real_distribution<double> uniform(-10, 10);
    const auto number = [&] { return whole ? std::round(uniform(random)) : uniform(random); };
    const Eigen::Vector3d some(number(), number(), number());
    switch (random() % 3) {
    case 0: {
        const Eigen::Vector3d other(number(), number(), number());
        return Box{some.cwiseMin(other), some.cwiseMax(other)};
    }
    case 1: return Sphere{some, std::abs(number()) / 2};
    default: return HalfSpace{(some + Eigen::Vector3d(0.5, 0, 0)).normalized(), number()};
    }
}

/// An expression of at most 2^(depth - 1) leaves.
inline ErrorField randomField(std::mt19937& random, int depth)
{
    std::uniform_real_distribution<double> number(0, 9);
    if (depth > 1 && random() % 4 != 0) {
        const ErrorField first = randomField(random, depth - 1);
        const ErrorField second = randomField(random, depth - 1);
        switch (random() % 4) {
        case 0: return first + second;
        case 1: return first * second;
        case 2: return smallerOf(first, second);
        default: return largerOf(first, second);
        }
    }
    switch (random() % 7) {
    case 0: return number(random);
    case 1: {
        ValueRamp ramp;
        for (unsigned count = random() % 6; count > 0; --count)
            ramp.knots.push_back({std::round(number(random) * 2 - 9), number(random)});
        return ramp;
    }
    default:
        return SpaceRamp{randomRegion(random), number(random), number(random), random() % 2 == 0 ? 0 : number(random)};
    }
}

} // namespace tetra
