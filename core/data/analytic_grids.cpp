// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/analytic_grids.h"

#include "core/base/portable_math.h"

#include <cmath>

namespace tetra {

namespace {

/// The sine and cosine of an angle in turns. Exact at multiples of a quarter.
struct GridDirection {
    double cosine;
    double sine;
};

GridDirection direction(double turns)
{
    return {portableCosineOfTurns(turns), portableCosineOfTurns(turns - 0.25)};
}

/// 0 far below, 1 far above.
double smoothStep(double x)
{
    return 1 / (1 + portableExponential(-x));
}

/// `x` in whole parts of 2^-bits.
double roundedTo(int bits, double x)
{
    return std::ldexp(std::floor(std::ldexp(x, bits) + 0.5), -bits);
}

/// Points of equal k lie exactly in a plane with the axis, in floats, too: otherwise cells at the axis, which have no
/// volume, would be turned over by rounding.
GridPoint bluntBody(const std::array<double, 3>& place)
{
    const double radius = 1 + place[0] * (0.7 + 1.3 * place[0]);
    const GridDirection fromAxis = direction(place[1] / 4);
    const GridDirection around = direction(place[2] / 2);
    const double shock = 1.5 + 0.6 * (1 - fromAxis.cosine);
    const double inside = smoothStep((shock - radius) / 0.05);
    const double strength = 0.3 + 0.7 * fromAxis.cosine * fromAxis.cosine;
    const double distance = roundedTo(11, radius * fromAxis.sine); // with 10 bits more it fits the 24 of a float
    return {
        {-radius * fromAxis.cosine, distance * roundedTo(10, around.cosine), -distance * roundedTo(10, around.sine)},
        inside * strength / (radius * radius)};
}

GridPoint oGrid(const std::array<double, 3>& place)
{
    constexpr double length = 4;
    const GridDirection around = direction(place[0]);
    const double radius = 0.5 * portableExponential(3 * place[1]);
    const double inverseSquare = 0.25 / (radius * radius);
    const double outwards = (1 - inverseSquare) * around.cosine;
    const double along = -(1 + inverseSquare) * around.sine;
    const double pressure = 1 - outwards * outwards - along * along; // from -3 to 1
    const double span = 0.7 + 0.3 * direction(place[2]).cosine;
    return {{radius * around.cosine, radius * around.sine, length * place[2]}, 0.75 + 0.25 * pressure * span};
}

GridPoint bentDuct(const std::array<double, 3>& place)
{
    const GridDirection bend = direction(place[0] / 4);
    const double radius = 1.5 + place[1];
    const double profile = 16 * place[1] * (1 - place[1]) * place[2] * (1 - place[2]);
    const double shifted = 1 + 0.8 * (place[1] - 0.5) * bend.sine;
    return {{radius * bend.cosine, radius * bend.sine, place[2]}, profile * shifted / 1.04};
}

GridPoint stretched(const std::array<double, 3>& place)
{
    const double x = 4 * place[0];
    const double y = (portableExponential(4 * place[1]) - 1) / (portableExponential(4) - 1);
    const double z = 2 * place[2] * place[2];
    const double thickness = 0.02 + 0.05 * x;
    return {{x, y, z}, (1 - portableExponential(-y / thickness)) * (0.9 + 0.1 * direction(z / 2).cosine)};
}

} // namespace

GridFunction gridFunction(std::string_view name)
{
    if (name == "blunt-body")
        return bluntBody;
    if (name == "o-grid")
        return oGrid;
    if (name == "bent-duct")
        return bentDuct;
    if (name == "stretched")
        return stretched;
    return {};
}

} // namespace tetra
