// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/analytic_functions.h"

#include "core/base/portable_math.h"
#include "core/data/split_mix.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tetra {

namespace {

/// Coordinates of the cube's points along an axis, in [-1, 1].
std::vector<double> axisCoordinates(std::uint32_t size)
{
    std::vector<double> coordinates(size);
    for (std::uint32_t i = 0; i < size; ++i)
        coordinates[i] = (2.0 * i - (size - 1.0)) / (size - 1.0);
    return coordinates;
}

constexpr std::size_t atomCount = 60;

/// The corners of the truncated icosahedron with edge length 2: the even permutations of (0, 1, 3g), (1, 2 + g, 2g) and
/// (g, 2, 2g + 1) with all signs, g the golden ratio.
std::array<Eigen::Vector3d, atomCount> truncatedIcosahedron()
{
    const double golden = (1 + std::sqrt(5.0)) / 2;
    const std::array<Eigen::Vector3d, 3> families = {Eigen::Vector3d(0, 1, 3 * golden),
                                                     Eigen::Vector3d(1, 2 + golden, 2 * golden),
                                                     Eigen::Vector3d(golden, 2, 2 * golden + 1)};
    std::array<Eigen::Vector3d, atomCount> corners;
    std::size_t count = 0;
    for (const Eigen::Vector3d& family : families)
        for (int shift = 0; shift < 3; ++shift)
            for (int signs = 0; signs < 8; ++signs) {
                if (family[0] == 0 && (signs & 1) != 0)
                    continue; // zero has no second sign
                Eigen::Vector3d corner;
                for (int axis = 0; axis < 3; ++axis)
                    corner[(axis + shift) % 3] = (signs >> axis & 1) != 0 ? -family[axis] : family[axis];
                corners[count++] = corner;
            }
    return corners;
}

/// A Gaussian is the product of one factor per axis: tables of size * 60 numbers take the place of size^3 * 60
/// exponentials.
struct GaussianTables {
    std::uint32_t size = 0;
    std::array<std::vector<double>, 3> factors; ///< factors[axis][atom * size + i]
};

GaussianTables gaussianTables(std::uint32_t size, double reach, double width)
{
    constexpr double bond = 1.43;
    const std::array<Eigen::Vector3d, atomCount> atoms = truncatedIcosahedron();
    const std::vector<double> coordinates = axisCoordinates(size);
    GaussianTables tables{size, {}};
    for (int axis = 0; axis < 3; ++axis)
        for (const Eigen::Vector3d& atom : atoms)
            for (const double coordinate : coordinates) {
                const double distance = (coordinate * reach - atom[axis] * (bond / 2)) / width;
                tables.factors[axis].push_back(portableExponential(-0.5 * distance * distance));
            }
    return tables;
}

} // namespace

RowFunction c60Density(std::uint32_t size)
{
    constexpr double reach = 4.7;
    constexpr double width = 0.62;
    constexpr double largest = 1.218187078; // near each atom, a little inside the cage; found by search, rounded up
    return [tables = gaussianTables(size, reach, width)](std::uint32_t j, std::uint32_t k, std::span<double> row) {
        std::ranges::fill(row, 0.0);
        for (std::size_t atom = 0; atom < atomCount; ++atom) {
            const std::size_t first = atom * tables.size;
            const double weight = tables.factors[1][first + j] * tables.factors[2][first + k] / largest;
            for (std::size_t i = 0; i < row.size(); ++i)
                row[i] += weight * tables.factors[0][first + i];
        }
    };
}

RowFunction hydrogenDensity(std::uint32_t size)
{
    return [places = axisCoordinates(size)](std::uint32_t j, std::uint32_t k, std::span<double> row) {
        constexpr double reach = 20;
        const double y = reach * places[j];
        const double z = reach * places[k];
        for (std::size_t i = 0; i < row.size(); ++i) {
            const double x = reach * places[i];
            const double radiusSquared = x * x + y * y + z * z;
            const double amplitude = (3 * z * z - radiusSquared) / 72;
            row[i] = amplitude * amplitude * portableExponential(4 - std::sqrt(radiusSquared) * 2 / 3);
        }
    };
}

RowFunction marschnerLobbSignal(std::uint32_t size)
{
    return [places = axisCoordinates(size)](std::uint32_t j, std::uint32_t k, std::span<double> row) {
        constexpr double frequency = 6;
        constexpr double ripple = 0.25;
        const double slope = 1 - portableCosineOfTurns(places[k] / 4 - 0.25); // the sine of a quarter turn times z
        for (std::size_t i = 0; i < row.size(); ++i) {
            const double radius = std::sqrt(places[i] * places[i] + places[j] * places[j]);
            const double wave = portableCosineOfTurns(frequency * portableCosineOfTurns(radius / 4));
            row[i] = (slope + ripple * (1 + wave)) / (2 * (1 + ripple));
        }
    };
}

RowFunction whiteNoise(std::uint32_t size, std::uint64_t seed)
{
    return [size, seed](std::uint32_t j, std::uint32_t k, std::span<double> row) {
        const std::uint64_t first = (std::uint64_t(k) * size + j) * size;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::uint64_t bits = splitMix(seed + (first + i + 1) * splitMixStep);
            row[i] = static_cast<double>(bits >> 11) * 0x1p-53;
        }
    };
}

} // namespace tetra
