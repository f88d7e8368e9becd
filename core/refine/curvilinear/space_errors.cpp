// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/curvilinear/space_errors.h"

#include "core/base/rounding.h"
#include "core/geometry/orientation.h"
#include "core/mesh/topology.h"

#include <Eigen/Geometry>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace tetra {

namespace {

using Place = std::array<double, 3>;

constexpr std::uint64_t notMeasured = ~std::uint64_t(0);

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

__extension__ using Quadruple = __float128;

struct Deviation {
    double error = 0;
    double doubt = 0; ///< how much of it may be rounding
};

/// How far the linear function that has the corners' values is from the point's value at its place, by the volumes of
/// the point with three corners each.
template <class Real>
Deviation deviation(const std::array<const PhysicalPoint*, 4>& corners, const PhysicalPoint& point)
{
    using Way = std::array<Real, 3>;
    const auto from = [&point](const PhysicalPoint& to) {
        Way way{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            way[axis] = static_cast<Real>(to.components[axis]) - static_cast<Real>(point.components[axis]);
        return way;
    };
    const std::array<Way, 4> ways = {from(*corners[0]), from(*corners[1]), from(*corners[2]), from(*corners[3])};
    const auto size = [](Real number) { return number < 0 ? -number : number; };
    Real sum = 0, volume = 0, doubtOfSum = 0, doubtOfVolume = 0;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const auto& [first, second, third] = cornersOfFace[corner];
        const Way &a = ways[first], &b = ways[second], &c = ways[third];
        const Real rise = static_cast<Real>(corners[corner]->components[3]) - static_cast<Real>(point.components[3]);
        for (std::size_t x = 0; x < 3; ++x) {
            const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
            const Real one = a[x] * b[y] * c[z], other = a[x] * b[z] * c[y];
            volume += one - other;
            sum += rise * (one - other);
            doubtOfVolume += size(one) + size(other);
            doubtOfSum += size(rise) * (size(one) + size(other));
        }
    }
    constexpr Real unit = 64 * static_cast<Real>(std::numeric_limits<long double>::epsilon());
    const Real certain = size(volume) - unit * doubtOfVolume;
    if (!(certain > 0))
        return {size(volume) > 0 ? static_cast<double>(size(sum / volume)) : 0,
                std::numeric_limits<double>::infinity()};
    const Real error = size(sum / volume);
    return {static_cast<double>(error), static_cast<double>(unit * (doubtOfSum + error * doubtOfVolume) / certain)};
}

/// A triangle's place next to another one.
struct NextPlace {
    double squaredDistance = std::numeric_limits<double>::infinity();
    double value = 0;
};

NextPlace nextPlace(const std::array<const PhysicalPoint*, 3>& corners, const Eigen::Vector3d& from)
{
    const std::array<Eigen::Vector3d, 3> places = {vectorOf(*corners[0]), vectorOf(*corners[1]), vectorOf(*corners[2])};
    const Eigen::Vector3d ab = places[1] - places[0], ac = places[2] - places[0], to = from - places[0];
    const Eigen::Vector3d normal = ab.cross(ac);
    const double area = normal.squaredNorm();
    const auto value = [&corners](std::size_t corner) { return corners[corner]->components[3]; };
    if (area > 0) {
        const double b = normal.dot(to.cross(ac)) / area, c = normal.dot(ab.cross(to)) / area;
        if (b >= 0 && c >= 0 && b + c <= 1)
            return {(to - b * ab - c * ac).squaredNorm(),
                    value(0) + b * (value(1) - value(0)) + c * (value(2) - value(0))};
    }
    NextPlace best;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::size_t next = (corner + 1) % 3;
        const Eigen::Vector3d edge = places[next] - places[corner];
        const double length = edge.squaredNorm();
        const double along = length > 0 ? std::clamp(edge.dot(from - places[corner]) / length, 0.0, 1.0) : 0;
        const double distance = (places[corner] + along * edge - from).squaredNorm();
        if (distance < best.squaredDistance)
            best = {distance, value(corner) + along * (value(next) - value(corner))};
    }
    return best;
}

} // namespace

SpaceErrors::SpaceErrors(const CurvilinearGrid& grid, double extent)
    : grid_(grid), extent_(extent),
      measured_(std::size_t(grid.lattice().size()[0]) * grid.lattice().size()[1] * grid.lattice().size()[2])
{
    tree_ = BoxTree(
        measured_.size(), [&grid](std::uint32_t point) { return Eigen::AlignedBox3d(vectorOf(grid[point])); },
        [&grid](std::uint32_t point, Eigen::Index axis) {
            return grid[point].components[static_cast<std::size_t>(axis)];
        });
}

/// Keeps the smaller of two bounds, and of equal ones that of the first tetrahedron. What cannot be told from none is
/// none.
void SpaceErrors::note(std::uint32_t point, double error, std::uint32_t slot)
{
    const double weighted = error * (grid_.weighted() ? grid_.weight(grid_.lattice().pointAt(point)) : 1);
    const float bound = weighted > 5e-13 * extent_ ? roundedUp(weighted) : 0.0f;
    const std::uint64_t entry = std::uint64_t(std::bit_cast<std::uint32_t>(bound)) << 32 | slot;
    std::uint64_t known = measured_[point].load(std::memory_order_relaxed);
    while (entry < known && !measured_[point].compare_exchange_weak(known, entry, std::memory_order_relaxed))
        ;
}

void SpaceErrors::measureIn(const DelaunayTetrahedron& tetrahedron, std::uint32_t slot)
{
    std::array<const PhysicalPoint*, 4> corners{};
    std::array<Place, 4> places{};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const std::uint32_t point = grid_.lattice().index(tetrahedron.vertices[corner]);
        measured_[point].store(0, std::memory_order_relaxed);
        corners[corner] = &grid_[point];
        places[corner] = grid_[point].position();
    }
    const int sign = orientationSign(places[0], places[1], places[2], places[3]);
    if (sign == 0)
        return;
    if (sign < 0) {
        std::swap(corners[2], corners[3]);
        std::swap(places[2], places[3]);
    }
    Eigen::AlignedBox3d box;
    for (const PhysicalPoint* corner : corners)
        box.extend(vectorOf(*corner));
    const auto meets = [&box](const Eigen::AlignedBox3d& other) { return box.intersects(other); };
    tree_.visitNear(meets, [&](std::uint32_t point) {
        const PhysicalPoint& at = grid_[point];
        if (measured_[point].load(std::memory_order_relaxed) >> 32 == 0 || !box.contains(vectorOf(at)) ||
            !holds(places, at.position()))
            return;
        const double enough = 1e-13 * extent_;
        Deviation found = deviation<long double>(corners, at);
        if (!(found.doubt <= enough))
            found = {deviation<Quadruple>(corners, at).error, enough};
        note(point, found.error + found.doubt, slot);
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

void SpaceErrors::measureOutside(std::span<const DelaunayTetrahedron> tetrahedra)
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
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(measured_.size()), 1024),
                      [&](const auto& range) {
                          for (std::uint32_t point = range.begin(); point != range.end(); ++point) {
                              if (measured_[point].load(std::memory_order_relaxed) != notMeasured)
                                  continue;
                              const Eigen::Vector3d place = vectorOf(grid_[point]);
                              NextPlace best;
                              std::uint32_t slot = 0;
                              tree.visitNearer(
                                  place, [&best] { return std::sqrt(best.squaredDistance); },
                                  [&](std::uint32_t face) {
                                      const NextPlace next = nextPlace(boundary.faces[face], place);
                                      if (!(next.squaredDistance < best.squaredDistance))
                                          return;
                                      best = next;
                                      slot = boundary.slots[face];
                                  });
                              note(point, std::abs(best.value - grid_[point].components[3]) + 1e-13 * extent_, slot);
                          }
                      });
}

float SpaceErrors::measure(std::span<const DelaunayTetrahedron> tetrahedra, double limit, std::vector<Worst>& found)
{
    for (std::atomic<std::uint64_t>& measured : measured_)
        measured.store(notMeasured, std::memory_order_relaxed);
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(tetrahedra.size()), 64),
                      [&](const auto& range) {
                          for (std::uint32_t slot = range.begin(); slot != range.end(); ++slot)
                              if (tetrahedra[slot].determinant() != 0)
                                  measureIn(tetrahedra[slot], slot);
                      });
    measureOutside(tetrahedra);
    found.clear();
    float largest = 0;
    for (std::uint32_t point = 0; point < measured_.size(); ++point) {
        const std::uint64_t entry = measured_[point].load(std::memory_order_relaxed);
        const auto error = std::bit_cast<float>(static_cast<std::uint32_t>(entry >> 32));
        largest = std::max(largest, error);
        if (static_cast<double>(error) > limit)
            found.push_back({point, error, static_cast<std::uint32_t>(entry)});
    }
    const auto isWorse = [](const Worst& one, const Worst& other) {
        return one.error != other.error ? one.error > other.error : one.point < other.point;
    };
    std::ranges::sort(found, [&](const Worst& one, const Worst& other) {
        return one.slot != other.slot ? one.slot < other.slot : isWorse(one, other);
    });
    const auto others = std::ranges::unique(found, {}, &Worst::slot);
    found.erase(others.begin(), others.end());
    std::ranges::sort(found, isWorse);
    return largest;
}

} // namespace tetra
