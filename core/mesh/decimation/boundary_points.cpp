// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/boundary_points.h"

#include <algorithm>

namespace tetra {

void BoundaryPoints::clear(std::uint32_t triangle)
{
    pool_.release(at(triangle).outside);
    pool_.release(at(triangle).ofBoundary);
    at(triangle) = {};
}

void BoundaryPoints::addOutside(std::uint32_t triangle, std::uint32_t point, float error, float warping)
{
    Relation& relation = at(triangle);
    relation.outside = pool_.appended(relation.outside, {&point, 1});
    relation.error = std::max(relation.error, error);
    relation.warping = std::max(relation.warping, warping);
}

void BoundaryPoints::addOfBoundary(std::uint32_t triangle, std::uint32_t point, float warping)
{
    Relation& relation = at(triangle);
    relation.ofBoundary = pool_.appended(relation.ofBoundary, {&point, 1});
    relation.warping = std::max(relation.warping, warping);
}

void BoundaryPoints::takeOutside(std::uint32_t triangle, std::uint32_t point)
{
    Relation& relation = at(triangle);
    const auto points = pool_[relation.outside];
    *std::ranges::find(points, point) = points.back();
    relation.outside = pool_.shortened(relation.outside);
}

} // namespace tetra
