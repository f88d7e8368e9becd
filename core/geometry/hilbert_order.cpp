// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/hilbert_order.h"

#include "core/base/simd.h"

#include <Eigen/Geometry>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>

namespace tetra {
namespace {

constexpr std::size_t pointsKeyedAtOnce = std::size_t(1) << 14;
constexpr int axisBits = spatialKeyBits / 3;
constexpr float cubes = 1 << axisBits;

Eigen::AlignedBox3d boundsOf(std::span<const Eigen::Vector3d> points)
{
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, points.size(), pointsKeyedAtOnce), Eigen::AlignedBox3d(),
        [&](const auto& range, Eigen::AlignedBox3d box) {
            for (std::size_t i = range.begin(); i != range.end(); ++i)
                if (points[i].allFinite())
                    box.extend(points[i]);
            return box;
        },
        [](const Eigen::AlignedBox3d& one, const Eigen::AlignedBox3d& other) { return one.merged(other); });
}

/// Puts two zeros after each of the lowest ten bits.
TETRA_SIMD_INLINE std::uint32_t spread(std::uint32_t bits)
{
    bits = (bits | bits << 16) & 0x030000ffu;
    bits = (bits | bits << 8) & 0x0300f00fu;
    bits = (bits | bits << 4) & 0x030c30c3u;
    return (bits | bits << 2) & 0x09249249u;
}

/// The place of a cube on the curve (J. Skilling, "Programming the Hilbert curve", AIP Conference Proceedings 707,
/// 2004), with masks in place of branches.
TETRA_SIMD_INLINE std::uint32_t hilbertKey(std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
    const auto turn = [&](std::uint32_t& axis, int bit) {
        const std::uint32_t below = (1u << bit) - 1;
        const std::uint32_t set = 0u - (axis >> bit & 1u);
        const std::uint32_t swapped = (x ^ axis) & below & ~set;
        x ^= swapped | (below & set);
        axis ^= swapped;
    };
    for (int bit = axisBits - 1; bit > 0; --bit) {
        x ^= ((1u << bit) - 1) & (0u - (x >> bit & 1u));
        turn(y, bit);
        turn(z, bit);
    }
    y ^= x;
    z ^= y;
    std::uint32_t flips = 0;
    for (int bit = axisBits - 1; bit > 0; --bit)
        flips ^= ((1u << bit) - 1) & (0u - (z >> bit & 1u));
    return spread(x ^ flips) << 2 | spread(y ^ flips) << 1 | spread(z ^ flips);
}

/// Which cube along an axis; the last for what is no number.
TETRA_SIMD_INLINE std::uint32_t cubeOf(double offset, float scale)
{
    const float place = static_cast<float>(offset) * scale;
    const float bounded = place < cubes - 1 ? place : cubes - 1;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(bounded > 0 ? bounded : 0));
}

TETRA_SIMD_INLINE void hilbertKeys(const double* coordinates, std::size_t first, std::size_t last, const double* origin,
                                   float scale, KeyedIndex* keys)
{
    const double x = origin[0], y = origin[1], z = origin[2];
    for (std::size_t i = first; i < last; ++i)
        keys[i] = {hilbertKey(cubeOf(coordinates[3 * i] - x, scale), cubeOf(coordinates[3 * i + 1] - y, scale),
                              cubeOf(coordinates[3 * i + 2] - z, scale)),
                   static_cast<std::uint32_t>(i)};
}

} // namespace

Buffer<KeyedIndex> spatialKeys(std::span<const Eigen::Vector3d> points)
{
    const Eigen::AlignedBox3d box = boundsOf(points);
    const Eigen::Vector3d origin = box.isEmpty() ? Eigen::Vector3d(0, 0, 0) : box.min();
    const auto side = static_cast<float>(box.isEmpty() ? 0 : box.sizes().maxCoeff());
    const float scale = side > 0 ? cubes / side : 0;
    Buffer<KeyedIndex> keys(points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), pointsKeyedAtOnce), [&](const auto& range) {
        dispatch<hilbertKeys>(points.data()->data(), range.begin(), range.end(), origin.data(), scale, keys.data());
    });
    return keys;
}

} // namespace tetra
