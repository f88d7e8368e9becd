// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/lifted_grid.h"

#include "core/mesh/exact_orientation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tetra {

namespace {

/// Residuals are sums of a few products of numbers of this size, each rounded at 2^-53 of it.
double roundingOf(double magnitude)
{
    return std::ldexp(magnitude, -48);
}

} // namespace

LiftedGrid::LiftedGrid(const std::array<std::uint32_t, 3>& size, std::span<const Eigen::Vector3d> positions,
                       const LatticeSamples& samples)
    : lattice_(size)
{
    points_.resize(positions.size());
    weights_.resize(samples.weighted() ? positions.size() : 0);
    std::vector<PackedPoint> row(size[0]);
    std::vector<double> values(size[0]);
    double largestValue = 0;
    double largestCoordinate = 0;
    std::size_t index = 0;
    for (std::uint32_t z = 0; z < size[2]; ++z)
        for (std::uint32_t y = 0; y < size[1]; ++y) {
            for (std::uint32_t x = 0; x < size[0]; ++x)
                row[x] = lattice_.pack(x, y, z);
            samples.gather(lattice_, row, values.data());
            for (std::uint32_t x = 0; x < size[0]; ++x, ++index) {
                const Eigen::Vector3d& position = positions[index];
                points_[index].components = {position.x(), position.y(), position.z(), values[x]};
                if (samples.weighted())
                    weights_[index] = samples.weight(lattice_, row[x]);
                largestValue = std::max(largestValue, std::abs(values[x]));
                largestCoordinate = std::max(largestCoordinate, position.cwiseAbs().maxCoeff());
            }
        }
    leastError_ = roundingOf(largestValue);
    leastWarping_ = roundingOf(2 * largestCoordinate);
    handedness_ = balanceOfCellCorners() < 0 ? -1 : 1;
}

/// Positive corners of cells less negative ones. Signs in doubles will do for that.
std::int64_t LiftedGrid::balanceOfCellCorners() const
{
    const auto& size = lattice_.size();
    const auto position = [this](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        return Eigen::Vector3d(this->position(lattice_.pack(x, y, z)).data());
    };
    std::int64_t balance = 0;
    for (std::uint32_t z = 0; z + 1 < size[2]; ++z)
        for (std::uint32_t y = 0; y + 1 < size[1]; ++y)
            for (std::uint32_t x = 0; x + 1 < size[0]; ++x)
                for (std::uint32_t corner = 0; corner < 8; ++corner) {
                    const std::uint32_t dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2 & 1;
                    const Eigen::Vector3d at = position(x + dx, y + dy, z + dz);
                    const Eigen::Vector3d u = position(x + 1 - dx, y + dy, z + dz) - at;
                    const Eigen::Vector3d v = position(x + dx, y + 1 - dy, z + dz) - at;
                    const Eigen::Vector3d w = position(x + dx, y + dy, z + 1 - dz) - at;
                    // Each edge that runs backwards turns the sign.
                    const double volume = u.dot(v.cross(w)) * ((dx + dy + dz) % 2 == 0 ? 1 : -1);
                    balance += volume > 0 ? 1 : volume < 0 ? -1 : 0;
                }
    return balance;
}

int LiftedGrid::orientation(const std::array<PackedPoint, 4>& vertices) const
{
    return handedness_ *
           orientationSign(position(vertices[0]), position(vertices[1]), position(vertices[2]), position(vertices[3]));
}

} // namespace tetra
