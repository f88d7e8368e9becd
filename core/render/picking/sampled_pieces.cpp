// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/picking/sampled_pieces.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace tetra {
namespace {

/// The trilinear field of samples at a place in steps of their lattice, within it.
double valueAt(const SampledField& field, const Eigen::Vector3d& place)
{
    std::array<std::uint32_t, 3> first{};
    std::array<double, 3> share{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double last = field.lattice.size[axis] - 1;
        const double bounded = std::clamp(place[static_cast<int>(axis)], 0.0, last);
        first[axis] = static_cast<std::uint32_t>(std::min(bounded, last - 1));
        share[axis] = bounded - first[axis];
    }
    double value = 0;
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        double weight = 1;
        std::array<std::uint32_t, 3> at = first;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool next = (corner >> axis & 1U) != 0;
            at[axis] += next ? 1 : 0;
            weight *= next ? share[axis] : 1 - share[axis];
        }
        value += weight * field.values.at(field.lattice.index(at[0], at[1], at[2]));
    }
    return value;
}

} // namespace

std::vector<SampledPiece> sampledPieces(const SampledField& field, const PickingRay& line, const PickingInterval& part)
{
    constexpr double piecesPerCell = 4;
    const Lattice& lattice = field.lattice;
    const Eigen::Matrix3d indexFromWorld = (lattice.directions * lattice.spacing.asDiagonal()).inverse();
    const Eigen::Vector3d at = indexFromWorld * (line.origin - lattice.origin);
    const Eigen::Vector3d along = indexFromWorld * line.direction;
    PickingInterval inside = part;
    for (int axis = 0; axis < 3; ++axis) {
        const double last = lattice.size[static_cast<std::size_t>(axis)] - 1;
        if (along[axis] == 0 && (at[axis] < 0 || at[axis] > last))
            return {};
        if (along[axis] != 0) {
            const auto [near, far] = std::minmax({-at[axis] / along[axis], (last - at[axis]) / along[axis]});
            inside = {std::max(inside.from, near), std::min(inside.to, far)};
        }
    }
    std::vector<SampledPiece> all;
    if (inside.isEmpty())
        return all;
    const double pieces = std::ceil((inside.to - inside.from) * along.cwiseAbs().maxCoeff() * piecesPerCell);
    const double step = (inside.to - inside.from) / pieces;
    double before = valueAt(field, at + inside.from * along);
    for (double piece = 0; piece < pieces; ++piece) {
        const PickingInterval here{inside.from + piece * step, inside.from + (piece + 1) * step};
        const double value = valueAt(field, at + here.to * along);
        all.push_back({here, before, value});
        before = value;
    }
    return all;
}

} // namespace tetra
