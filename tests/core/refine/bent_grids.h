// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/curvilinear/curvilinear_refinement.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace tetra {

/// A small curvilinear grid. Positions are multiples of 1/64, so that a test finds signs of volumes in integers.
struct BentGrid {
    std::array<std::uint32_t, 3> size{2, 2, 2};
    std::vector<Eigen::Vector3d> positions;
    std::vector<double> values;

    std::array<std::uint32_t, 3> place(std::uint64_t point) const
    {
        return {static_cast<std::uint32_t>(point % size[0]), static_cast<std::uint32_t>(point / size[0] % size[1]),
                static_cast<std::uint32_t>(point / size[0] / size[1])};
    }
    double valueExtent() const
    {
        const auto [least, greatest] = std::ranges::minmax(values);
        return greatest - least;
    }
    double diagonal() const
    {
        Eigen::Vector3d least = positions[0], greatest = positions[0];
        for (const Eigen::Vector3d& position : positions) {
            least = least.cwiseMin(position);
            greatest = greatest.cwiseMax(position);
        }
        return (greatest - least).norm();
    }
    Result<CurvilinearRefinementResult> refine(const CurvilinearRefinementOptions& options, HistorySink& sink,
                                               const Progress& progress = {}, std::span<const float> weights = {}) const
    {
        return refineCurvilinear(size, positions, LatticeSamples(std::span<const double>(values), weights), options,
                                 sink, progress);
    }
    CurvilinearRefinementOptions options() const
    {
        CurvilinearRefinementOptions result;
        result.warpingWeight = valueExtent() / diagonal();
        result.valueExtent = valueExtent();
        result.positionExtent = diagonal();
        return result;
    }
};

using Bend = std::function<Eigen::Vector3d(double x, double y, double z)>;

/// The point (x, y, z) of the lattice goes to bend(x, y, z); values are smooth there.
inline BentGrid bentGrid(const std::array<std::uint32_t, 3>& size, const Bend& bend)
{
    BentGrid grid{size, {}, {}};
    for (std::uint32_t z = 0; z < size[2]; ++z)
        for (std::uint32_t y = 0; y < size[1]; ++y)
            for (std::uint32_t x = 0; x < size[0]; ++x) {
                const Eigen::Vector3d position = ((64 * bend(x, y, z)).array().round() / 64).matrix();
                grid.positions.push_back(position);
                grid.values.push_back(std::sin(0.5 * position.x()) + std::cos(0.3 * position.y() + 0.4 * position.z()));
            }
    return grid;
}

/// A duct that turns by a right angle.
inline BentGrid bentDuct()
{
    return bentGrid({11, 5, 6}, [](double x, double y, double z) {
        const double angle = 0.157 * x, radius = 3 + y;
        return Eigen::Vector3d(radius * std::sin(angle), radius * std::cos(angle), z);
    });
}

/// An O-grid: its first plane along y lies on its last. Right-handed.
inline BentGrid wrappedGrid()
{
    return bentGrid({6, 13, 4}, [](double x, double y, double z) {
        const double angle = 2 * 3.14159265358979 / 12 * std::fmod(y, 12);
        return Eigen::Vector3d((1 + x) * std::cos(angle), (1 + x) * std::sin(angle), z);
    });
}

/// A body of revolution: the plane x = 0 collapses into the axis, its row y = z = 0 into a point.
inline BentGrid collapsedGrid()
{
    return bentGrid({7, 7, 8}, [](double x, double y, double z) {
        const double angle = 0.3 * y, radius = x;
        return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
    });
}

/// The points of a regular lattice shaken by up to `amount` of a cell along each axis, with values likewise random.
inline BentGrid shakenGrid(const std::array<std::uint32_t, 3>& size, double amount, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-amount, amount);
    BentGrid grid = bentGrid(size, [&](double x, double y, double z) {
        const double dx = shift(random), dy = shift(random), dz = shift(random);
        return Eigen::Vector3d(x + dx, y + dy, z + dz);
    });
    for (double& value : grid.values)
        value += shift(random);
    return grid;
}

/// A C-grid: its lines along x lie on one another beside the wake, and turn about a body in between. The layers around
/// the body are thin.
inline BentGrid cGrid(const std::array<std::uint32_t, 3>& size, double growth)
{
    return bentGrid(size, [&](double x, double y, double z) {
        const double along = 2 * x / (size[0] - 1) - 1; // the body between -0.5 and 0.5
        const double away = (std::pow(growth, y) - 1) / (growth - 1) / 4;
        const double sheared = z + 0.1 * y;
        if (std::abs(along) <= 0.5)
            return Eigen::Vector3d(-(2 + away) * std::cos(3.14159265358979 * along),
                                   (2 + away) * std::sin(3.14159265358979 * along), sheared);
        const double side = along > 0 ? 1 : -1;
        return Eigen::Vector3d(12 * (std::abs(along) - 0.5), side * (away + 2 * std::max(0.0, 1.5 - std::abs(along))),
                               sheared);
    });
}

/// An O-grid about a body, closed or with a gap, whose layers grow outwards.
inline BentGrid oGrid(const std::array<std::uint32_t, 3>& size, double growth, double turn)
{
    return bentGrid(size, [&](double x, double y, double z) {
        const double angle = 2 * 3.14159265358979 * turn * std::fmod(y, size[1] - 1) / (size[1] - 1);
        const double radius = 1 + (std::pow(growth, x) - 1) / (growth - 1) / 4;
        return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z + 0.2 * x);
    });
}

/// One of the above, at random: even, folded, wrapped, collapsed.
inline BentGrid randomGrid(std::mt19937& random)
{
    const auto count = [&](std::uint32_t least, std::uint32_t most) {
        return least + static_cast<std::uint32_t>(random() % (most - least + 1));
    };
    const double growth = 1.1 + 0.01 * count(0, 60);
    switch (random() % 6) {
    case 0: return shakenGrid({count(2, 10), count(2, 10), count(2, 10)}, 0.2, static_cast<unsigned>(random()));
    case 1: return shakenGrid({count(2, 8), count(2, 8), count(2, 8)}, 0.9, static_cast<unsigned>(random()));
    case 2: return oGrid({count(3, 10), count(6, 24), count(2, 6)}, growth, 1);
    case 3: return cGrid({count(9, 24), count(3, 9), count(2, 6)}, growth);
    case 4: return oGrid({count(3, 10), count(6, 24), count(2, 6)}, growth, 0.05 * count(2, 19));
    default: break;
    }
    const double pitch = 0.02 * count(1, 30);
    return bentGrid({count(2, 9), count(3, 9), count(2, 9)}, [pitch](double x, double y, double z) {
        return Eigen::Vector3d(x * std::cos(pitch * y), x * std::sin(pitch * y), z);
    });
}

} // namespace tetra
