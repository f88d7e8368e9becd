// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/curvilinear/space_errors.h"

#include "core/base/rounding.h"
#include "core/geometry/orientation.h"
#include "core/geometry/triangles.h"
#include "core/mesh/tetrahedron_planes.h"
#include "core/mesh/topology.h"
#include "core/refine/interpolation.h"

#include <Eigen/Geometry>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace tetra {

namespace {

using Place = std::array<double, 3>;

// Where a point was measured is the tetrahedron's slot and one more, so that a site's bound is less than any other.
constexpr std::uint64_t notMeasured = ~std::uint64_t(0);
constexpr std::uint64_t ofSite = 0;

std::uint32_t slotOf(std::uint64_t measured)
{
    return static_cast<std::uint32_t>(measured) - 1;
}

constexpr double rounding = 1e-13; ///< of an error, of the extent of the values

Eigen::Vector3d vectorOf(const PhysicalPoint& point)
{
    return {point.components[0], point.components[1], point.components[2]};
}

/// Whether the tetrahedron, which is positive, holds the place, its boundary included. Exact.
bool holds(const std::array<Place, 4>& corners, const Place& place)
{
    for (std::size_t corner = 0; corner < 4; ++corner) {
        std::array<Place, 4> part = corners;
        part[corner] = place;
        if (orientationSign(part[0], part[1], part[2], part[3]) < 0)
            return false;
    }
    return true;
}

/// What is nearest to a place on some triangles.
struct NearestPlace {
    double squaredDistance = std::numeric_limits<double>::infinity();
    double value = 0;
    std::uint32_t triangle = 0;
};

/// Looks at one more triangle.
void look(const std::array<const PhysicalPoint*, 3>& corners, std::uint32_t triangle, const Place& place,
          NearestPlace& nearest)
{
    std::array<Place, 3> ways{};
    for (std::size_t corner = 0; corner < 3; ++corner)
        for (std::size_t axis = 0; axis < 3; ++axis)
            ways[corner][axis] = corners[corner]->components[axis] - place[axis];
    const auto weights = nearestWeights(ways);
    double squaredDistance = 0, value = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double away = weights[0] * ways[0][axis] + weights[1] * ways[1][axis] + weights[2] * ways[2][axis];
        squaredDistance += away * away;
    }
    for (std::size_t corner = 0; corner < 3; ++corner)
        value += weights[corner] * corners[corner]->components[3];
    if (squaredDistance < nearest.squaredDistance)
        nearest = {squaredDistance, value, triangle};
}

} // namespace

SpaceErrors::SpaceErrors(const CurvilinearGrid& grid, double extent)
    : grid_(grid), extent_(extent),
      measured_(std::size_t(grid.lattice().size()[0]) * grid.lattice().size()[1] * grid.lattice().size()[2])
{
    for (std::atomic<std::uint64_t>& measured : measured_)
        measured.store(notMeasured, std::memory_order_relaxed);
    all_ = placesOf(notMeasuredYet());
}

SpaceErrors::Places SpaceErrors::placesOf(std::vector<std::uint32_t> points) const
{
    Eigen::AlignedBox3d box;
    for (const std::uint32_t point : points)
        box.extend(vectorOf(grid_[point]));
    BoxTree tree(
        points.size(), [&](std::uint32_t item) { return Eigen::AlignedBox3d(vectorOf(grid_[points[item]])); },
        [&](std::uint32_t item, Eigen::Index axis) {
            return grid_[points[item]].components[static_cast<std::size_t>(axis)];
        });
    return {std::move(points), std::move(tree), box};
}

std::vector<std::uint32_t> SpaceErrors::notMeasuredYet() const
{
    std::vector<std::uint32_t> points;
    for (std::uint32_t point = 0; point < measured_.size(); ++point)
        if (measured_[point].load(std::memory_order_relaxed) == notMeasured)
            points.push_back(point);
    return points;
}

/// Keeps the smaller of two bounds, and of equal ones that of the first tetrahedron. What cannot be told from none is
/// none.
void SpaceErrors::note(std::uint32_t point, double error, std::uint32_t slot)
{
    const double weighted = error * (grid_.weighted() ? grid_.weight(grid_.lattice().pointAt(point)) : 1);
    const float bound = weighted > 5 * rounding * extent_ ? roundedUp(weighted) : 0.0f;
    const std::uint64_t entry = std::uint64_t(std::bit_cast<std::uint32_t>(bound)) << 32 | (slot + 1);
    std::uint64_t known = measured_[point].load(std::memory_order_relaxed);
    while (entry < known && !measured_[point].compare_exchange_weak(known, entry, std::memory_order_relaxed))
        ;
}

void SpaceErrors::measureIn(const DelaunayTetrahedron& tetrahedron, std::uint32_t slot, const Places& places)
{
    InterpolatingCell cell;
    std::array<Place, 4> corners{};
    Eigen::AlignedBox3d box;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const std::uint32_t point = grid_.lattice().index(tetrahedron.vertices[corner]);
        measured_[point].store(ofSite, std::memory_order_relaxed);
        corners[corner] = grid_[point].position();
        cell.corners[corner] = vectorOf(grid_[point]);
        cell.values[corner] = grid_[point].components[3];
        box.extend(cell.corners[corner]);
    }
    if (!places.box.intersects(box))
        return;
    const int sign = orientationSign(corners[0], corners[1], corners[2], corners[3]);
    if (sign == 0)
        return;
    if (sign < 0) {
        std::swap(corners[2], corners[3]);
        std::swap(cell.corners[2], cell.corners[3]);
        std::swap(cell.values[2], cell.values[3]);
    }
    const TetrahedronPlanes planes(cell.corners);
    const auto mayMeet = [&planes](const Eigen::AlignedBox3d& other) { return planes.mayMeet(other); };
    places.tree.visitNear(mayMeet, [&](std::uint32_t item) {
        const std::uint32_t point = places.points[item];
        const Eigen::Vector3d at = vectorOf(grid_[point]);
        if (measured_[point].load(std::memory_order_relaxed) == ofSite || !mayMeet({at, at}) ||
            !holds(corners, grid_[point].position()))
            return;
        note(point, interpolationError(cell, at, grid_[point].components[3]) + rounding * extent_, slot);
    });
}

/// The faces of the boundary, each with its tetrahedron.
struct SpaceErrors::Boundary {
    std::vector<std::array<const PhysicalPoint*, 3>> faces;
    std::vector<std::uint32_t> slots;

    Boundary(const CurvilinearGrid& grid, std::span<const DelaunayTetrahedron> tetrahedra)
    {
        for (std::uint32_t slot = 0; slot < tetrahedra.size(); ++slot)
            for (std::size_t opposite = 0; opposite < 4; ++opposite) {
                const DelaunayTetrahedron& tetrahedron = tetrahedra[slot];
                if (tetrahedron.determinant() == 0 || tetrahedron.neighbours[opposite] != LatticeDelaunay::none)
                    continue;
                const auto& [a, b, c] = cornersOfFace[opposite];
                faces.push_back({&grid.at(tetrahedron.vertices[a]), &grid.at(tetrahedron.vertices[b]),
                                 &grid.at(tetrahedron.vertices[c])});
                slots.push_back(slot);
            }
    }
};

void SpaceErrors::measureOutside(std::span<const DelaunayTetrahedron> tetrahedra, std::span<const std::uint32_t> points)
{
    const Boundary boundary(grid_, tetrahedra);
    const BoxTree tree(
        boundary.faces.size(),
        [&](std::uint32_t face) {
            Eigen::AlignedBox3d box;
            for (const PhysicalPoint* corner : boundary.faces[face])
                box.extend(vectorOf(*corner));
            return box;
        },
        [&](std::uint32_t face, Eigen::Index axis) {
            double sum = 0;
            for (const PhysicalPoint* corner : boundary.faces[face])
                sum += corner->components[static_cast<std::size_t>(axis)];
            return sum;
        });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 64), [&](const auto& range) {
        for (const std::uint32_t point : points.subspan(range.begin(), range.size())) {
            NearestPlace nearest;
            tree.visitNearer(
                vectorOf(grid_[point]), [&nearest] { return std::sqrt(nearest.squaredDistance); },
                [&](std::uint32_t face) { look(boundary.faces[face], face, grid_[point].position(), nearest); });
            note(point, std::abs(nearest.value - grid_[point].components[3]) + rounding * extent_,
                 boundary.slots[nearest.triangle]);
        }
    });
}

/// Finds the new tetrahedra; what was measured in those before them, or outside of all, is not known any more.
void SpaceErrors::forget(std::span<const DelaunayTetrahedron> tetrahedra)
{
    tetrahedra_.resize(tetrahedra.size());
    isNew_.assign(tetrahedra.size(), 0);
    for (std::uint32_t slot = 0; slot < tetrahedra.size(); ++slot) {
        const std::array<PackedPoint, 4> vertices =
            tetrahedra[slot].determinant() != 0 ? tetrahedra[slot].vertices : std::array<PackedPoint, 4>();
        isNew_[slot] = std::exchange(tetrahedra_[slot], vertices) != vertices ? 1 : 0;
    }
    for (std::atomic<std::uint64_t>& measured : measured_) {
        const std::uint64_t known = measured.load(std::memory_order_relaxed);
        if (known != ofSite && known != notMeasured && isNew_[slotOf(known)] != 0)
            measured.store(notMeasured, std::memory_order_relaxed);
    }
    for (const std::uint32_t point : outside_)
        measured_[point].store(notMeasured, std::memory_order_relaxed);
}

float SpaceErrors::measure(std::span<const DelaunayTetrahedron> tetrahedra, double limit, std::vector<Worst>& found)
{
    forget(tetrahedra);
    const auto measureAll = [&](bool areNew, const Places& places) {
        tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(tetrahedra.size()), 8),
                          [&](const auto& range) {
                              for (std::uint32_t slot = range.begin(); slot != range.end(); ++slot)
                                  if (tetrahedra[slot].determinant() != 0 && (isNew_[slot] != 0) == areNew)
                                      measureIn(tetrahedra[slot], slot, places);
                          });
    };
    measureAll(true, all_);
    // Where tetrahedra overlap, or the boundary has moved, a point may lie in an older one, unless it lay in none then.
    std::vector<std::uint32_t> lost;
    std::ranges::set_difference(notMeasuredYet(), outside_, std::back_inserter(lost));
    measureAll(false, placesOf(std::move(lost)));
    outside_ = notMeasuredYet();
    measureOutside(tetrahedra, outside_);
    found.clear();
    float largest = 0;
    for (std::uint32_t point = 0; point < measured_.size(); ++point) {
        const std::uint64_t entry = measured_[point].load(std::memory_order_relaxed);
        const auto error = std::bit_cast<float>(static_cast<std::uint32_t>(entry >> 32));
        largest = std::max(largest, error);
        if (static_cast<double>(error) > limit)
            found.push_back({point, error, slotOf(entry), tetrahedra[slotOf(entry)].vertices});
    }
    std::ranges::sort(found, [](const Worst& one, const Worst& other) {
        return one.slot != other.slot ? one.slot < other.slot : isWorse(one, other);
    });
    const auto others = std::ranges::unique(found, {}, &Worst::slot);
    found.erase(others.begin(), others.end());
    return largest;
}

} // namespace tetra
