// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>

#include <QByteArray>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

namespace tetra {

/// What the volumes of ../shared/cases hold at each place of the world, as the README there says; so that a reader is
/// judged by the file's format alone.
inline double worldFunction(const Eigen::Vector3d& place, double scale)
{
    const Eigen::Vector3d at = place / scale;
    return at[0] + 2 * at[1] + 4 * at[2] + 3 * std::sin(0.9 * at[0]) + 2 * std::cos(0.7 * at[1] + 0.3 * at[2]);
}

/// The largest difference of a sample from the function at its place.
inline double distanceFromWorld(const Dataset& dataset, double scale)
{
    double largest = 0;
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point)
        largest = std::max(largest, std::abs(dataset.values.at(point) - worldFunction(dataset.position(point), scale)));
    return largest;
}

/// Floats of the function at origin + steps (i, j, k), the first index running fastest.
inline QByteArray samplesOfWorld(const std::array<std::uint32_t, 3>& size, const Eigen::Matrix3d& steps,
                                 const Eigen::Vector3d& origin, double scale)
{
    QByteArray bytes;
    for (std::uint32_t k = 0; k < size[2]; ++k)
        for (std::uint32_t j = 0; j < size[1]; ++j)
            for (std::uint32_t i = 0; i < size[0]; ++i) {
                const auto value = static_cast<float>(worldFunction(origin + steps * Eigen::Vector3d(i, j, k), scale));
                bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
            }
    return bytes;
}

/// The 48 ways in which axes can be exchanged and mirrored; the first is none.
inline std::vector<Eigen::Matrix3d> signedPermutations()
{
    std::vector<Eigen::Matrix3d> all;
    std::array<int, 3> order{0, 1, 2};
    do
        for (unsigned signs = 0; signs < 8; ++signs) {
            Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
            for (int axis = 0; axis < 3; ++axis)
                matrix(order[static_cast<std::size_t>(axis)], axis) = (signs >> axis & 1) != 0 ? -1 : 1;
            all.push_back(matrix);
        }
    while (std::ranges::next_permutation(order).found);
    return all;
}

inline std::filesystem::path sharedCases()
{
    return std::filesystem::path(TAN_SOURCE_DIR) / ".." / "shared" / "cases";
}

} // namespace tetra
