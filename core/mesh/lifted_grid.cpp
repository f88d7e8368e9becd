// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/lifted_grid.h"

#include "core/mesh/exact_orientation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace tetra {

namespace {

/// Residuals are sums of a few products of numbers of this size, each rounded at 2^-53 of it.
double roundingOf(double magnitude)
{
    return std::ldexp(magnitude, -48);
}

/// Of a cell; the bits of a corner's number choose the later point along x, y and z.
using CellPositions = std::array<Eigen::Vector3d, 8>;

std::array<std::uint32_t, 8> cornerOffsets(const std::array<std::uint32_t, 3>& size)
{
    std::array<std::uint32_t, 8> offsets{};
    for (std::uint32_t corner = 0; corner < 8; ++corner)
        offsets[corner] = (corner & 1) + (corner >> 1 & 1) * size[0] + (corner >> 2) * size[0] * size[1];
    return offsets;
}

/// Each edge that runs backwards turns the sign.
int turnOfCorner(unsigned corner)
{
    return std::popcount(corner) % 2 == 0 ? 1 : -1;
}

/// Six times the volume of a cell's corner with its three edges, as doubles give it, and by how much that may be off.
struct CornerVolume {
    double six;
    double doubt;

    /// 0: there is a doubt.
    int sign() const { return std::abs(six) > doubt ? (six > 0 ? 1 : -1) : 0; }
};

CornerVolume cornerVolumeOf(const CellPositions& corners, unsigned corner)
{
    const Eigen::Vector3d& at = corners[corner];
    const Eigen::Vector3d u = corners[corner ^ 1] - at;
    const Eigen::Vector3d v = corners[corner ^ 2] - at;
    const Eigen::Vector3d w = corners[corner ^ 4] - at;
    const Eigen::Vector3d a = v.cwiseAbs(), b = w.cwiseAbs();
    const double size = u.cwiseAbs().dot(
        Eigen::Vector3d(a[1] * b[2] + a[2] * b[1], a[2] * b[0] + a[0] * b[2], a[0] * b[1] + a[1] * b[0]));
    // Where products underflow, no bound on their rounding holds.
    constexpr double least = 1e-290;
    return {turnOfCorner(corner) * u.dot(v.cross(w)), std::max(roundingOf(size), least)};
}

int cornerSignOf(const CellPositions& corners, unsigned corner)
{
    if (const int sign = cornerVolumeOf(corners, corner).sign(); sign != 0)
        return sign;
    const auto at = [&](unsigned number) {
        return std::array<double, 3>{corners[number].x(), corners[number].y(), corners[number].z()};
    };
    return turnOfCorner(corner) * orientationSign(at(corner), at(corner ^ 1), at(corner ^ 2), at(corner ^ 4));
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
    lookAtCells();
}

/// Finds the handedness, for which signs in doubles will do, and the folded cells, which are looked for only if not all
/// corners of cells are of that hand without doubt.
void LiftedGrid::lookAtCells()
{
    const auto& size = lattice_.size();
    const auto forEachCell = [&](const auto& visit) {
        const std::array<std::uint32_t, 8> offsets = cornerOffsets(size);
        for (std::uint32_t z = 0; z + 1 < size[2]; ++z)
            for (std::uint32_t y = 0; y + 1 < size[1]; ++y) {
                std::uint32_t first = (z * size[1] + y) * size[0];
                for (std::uint32_t x = 0; x + 1 < size[0]; ++x, ++first) {
                    CellPositions corners;
                    for (unsigned corner = 0; corner < 8; ++corner)
                        corners[corner] = Eigen::Vector3d(points_[first + offsets[corner]].components.data());
                    visit(corners, FoldedCells::Place{std::int32_t(x), std::int32_t(y), std::int32_t(z)});
                }
            }
    };
    std::int64_t balance = 0;
    std::array<bool, 2> anyDoubt{}; ///< that all corners are negative, and that all are positive
    forEachCell([&](const CellPositions& corners, const FoldedCells::Place&) {
        for (unsigned corner = 0; corner < 8; ++corner) {
            const CornerVolume volume = cornerVolumeOf(corners, corner);
            balance += volume.six > 0 ? 1 : volume.six < 0 ? -1 : 0;
            anyDoubt[0] |= volume.sign() >= 0;
            anyDoubt[1] |= volume.sign() <= 0;
        }
    });
    handedness_ = balance < 0 ? -1 : 1;
    if (!anyDoubt[handedness_ > 0 ? 1 : 0])
        return;
    std::vector<FoldedCells::Place> folded;
    forEachCell([&](const CellPositions& corners, const FoldedCells::Place& place) {
        for (unsigned corner = 0; corner < 8; ++corner)
            if (handedness_ * cornerSignOf(corners, corner) < 0) {
                folded.push_back(place);
                return;
            }
    });
    foldedCells_ = FoldedCells(std::move(folded));
}

int LiftedGrid::orientation(const std::array<PackedPoint, 4>& vertices) const
{
    return handedness_ *
           orientationSign(position(vertices[0]), position(vertices[1]), position(vertices[2]), position(vertices[3]));
}

bool LiftedGrid::bears(const std::array<PackedPoint, 4>& vertices) const
{
    FoldedCells::Corners corners{};
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] = {lattice_.x(vertices[i]), lattice_.y(vertices[i]), lattice_.z(vertices[i])};
    return isOfOneCell(corners) || foldedCells_.meet(corners);
}

} // namespace tetra
