// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/focus_division.h"

#include "core/mesh/lattice_metric.h"
#include "core/mesh/packed_lattice.h"

#include <algorithm>
#include <cmath>

namespace tetra {

namespace {

/// What is kept for a point takes memory only where it is touched, but address space everywhere.
constexpr std::uint64_t mostPoints = 1ull << 30;

bool isWeighted(const Model& model)
{
    return std::ranges::any_of(model.description().parameters, [](const auto& parameter) {
        return parameter.first == "weights" && !parameter.second.empty();
    });
}

/// The corners of all blocks, if these are what the initial sites are.
bool areCorners(const BlockDivision& division, const Lattice& lattice, std::span<const std::uint32_t> points)
{
    std::uint64_t corners = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
        corners *= division.countAlong(axis) + 1ull;
    return points.size() == corners && std::ranges::all_of(points, [&](std::uint32_t point) {
               const auto place = lattice.coordinates(point);
               return division.isBorder(0, place[0]) && division.isBorder(1, place[1]) && place[2] < lattice.size[2] &&
                      division.isBorder(2, place[2]);
           });
}

} // namespace

std::optional<BlockDivision> focusDivision(const Model& model)
{
    const Lattice& lattice = model.description().lattice;
    if (model.description().domain != DomainClass::RegularLattice || !model.description().delaunay ||
        isWeighted(model) || lattice.pointCount() > mostPoints || !PackedLattice::fits(lattice.size))
        return std::nullopt;
    const std::span<const float> errors = model.runningErrors();
    const auto end = std::ranges::partition_point(
        errors, [&](const float& error) { return model.check(error) && std::isinf(error); });
    const auto points = model.points().first(static_cast<std::size_t>(end - errors.begin()));
    if (!model.check(points))
        return std::nullopt;
    // Blocks of the same edge, but for the last: the least coordinate behind the first plane of any axis that is cut.
    std::uint32_t edge = 0;
    for (const std::uint32_t point : points) {
        const auto place = lattice.coordinates(point);
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (place[axis] > 0 && place[axis] + 1 < lattice.size[axis] && (edge == 0 || place[axis] < edge))
                edge = place[axis];
    }
    const BlockDivision division(lattice.size, edge);
    if (!areCorners(division, lattice, points) || !latticeMetric(division.box(0).size, lattice.spacing))
        return std::nullopt;
    return division;
}

} // namespace tetra
