// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/placed_cell.h"

#include "core/mesh/topology.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace tetra {

namespace {

__extension__ using Quadruple = __float128;

/// Cramer's rule from corner 0: the interpolation's gradient times the volume, along the way to the place.
template <class Real> struct Interpolation {
    Real numerator = 0; ///< of value - interpolation
    Real volume = 0;
    Real magnitude = 0; ///< what the numerator's rounding error is relative to
    Real volumeMagnitude = 0;

    Interpolation(const PlacedCell& cell, const std::array<double, 4>& values, const Eigen::Vector3d& place,
                  double value)
    {
        const auto from0 = [&](const Eigen::Vector3d& to) {
            std::array<Real, 3> way{};
            for (std::size_t x = 0; x < 3; ++x)
                way[x] = static_cast<Real>(to[static_cast<int>(x)]) - static_cast<Real>(cell[0][static_cast<int>(x)]);
            return way;
        };
        const std::array<Real, 3> way = from0(place);
        const std::array<std::array<Real, 3>, 3> edges = {from0(cell[1]), from0(cell[2]), from0(cell[3])};
        const auto size = [](Real number) { return number < 0 ? -number : number; };
        const Real start = static_cast<Real>(value) - static_cast<Real>(values[0]);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::array<Real, 3>& b = edges[(i + 1) % 3];
            const std::array<Real, 3>& c = edges[(i + 2) % 3];
            const Real rise = static_cast<Real>(values[i + 1]) - static_cast<Real>(values[0]);
            for (std::size_t x = 0; x < 3; ++x) {
                const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
                const Real first = b[y] * c[z], second = b[z] * c[y];
                numerator -= rise * way[x] * (first - second);
                magnitude += size(rise * way[x]) * (size(first) + size(second));
                if (i == 0) {
                    volume += edges[0][x] * (first - second);
                    volumeMagnitude += size(edges[0][x]) * (size(first) + size(second));
                }
            }
        }
        numerator += start * volume;
        magnitude += size(start) * volumeMagnitude;
    }
};

} // namespace

CellError quickError(const PlacedCell& cell, const std::array<double, 4>& values, const Eigen::Vector3d& place,
                     double value)
{
    constexpr double unit = 32 * 0x1p-53;
    const Interpolation<double> at(cell, values, place, value);
    const double volume = std::abs(at.volume) - unit * at.volumeMagnitude;
    if (!(volume > 0))
        return {0, std::numeric_limits<double>::infinity()};
    const double error = std::abs(at.numerator) / std::abs(at.volume);
    return {error, unit * (at.magnitude + error * at.volumeMagnitude) / volume};
}

double preciseError(const PlacedCell& cell, const std::array<double, 4>& values, const Eigen::Vector3d& place,
                    double value)
{
    const Interpolation<Quadruple> at(cell, values, place, value);
    return std::abs(static_cast<double>(at.numerator / at.volume));
}

} // namespace tetra
