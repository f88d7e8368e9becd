// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/boundary_surface.h"

#include "core/geometry/orientation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

constexpr int deepestLevel = 20; ///< below it a cell is a millionth of the whole

Eigen::AlignedBox3d triangleBox(std::span<const Eigen::Vector3d> positions, const SurfaceTriangle& triangle)
{
    Eigen::AlignedBox3d box;
    for (const std::uint32_t point : triangle)
        box.extend(positions[point]);
    return box;
}

bool haveSameCorners(const SurfaceTriangle& one, const SurfaceTriangle& other)
{
    return std::ranges::all_of(
        one, [&](std::uint32_t point) { return point == other[0] || point == other[1] || point == other[2]; });
}

bool isAmong(const SurfaceTriangle& triangle, std::span<const SurfaceTriangle> others)
{
    return std::ranges::any_of(others, [&](const SurfaceTriangle& other) { return haveSameCorners(triangle, other); });
}

/// The child on the way to a cell of these numbers, below a cell of that depth.
std::size_t childAt(const std::array<std::uint32_t, 3>& numbers, int depth)
{
    const int bit = deepestLevel - 1 - depth;
    std::size_t child = 0;
    for (std::size_t k = 0; k < 3; ++k)
        child |= std::size_t((numbers[k] >> bit) & 1U) << k;
    return child;
}

/// The plane of a triangle in floating point, to leave out cells that lie off it.
class RoughPlane {
public:
    /// `largest` is no less than any coordinate of the surface.
    RoughPlane(std::span<const Eigen::Vector3d> positions, const SurfaceTriangle& t, double largest)
        : point_(positions[t[0]])
    {
        const Eigen::Vector3d one = positions[t[1]] - point_, other = positions[t[2]] - point_;
        normal_ = one.cross(other);
        rounding_ = 1e-14 * largest * (one.lpNorm<1>() + other.lpNorm<1>());
    }
    /// Whether it may come through the cube; true wherever rounding might decide.
    bool passes(const Eigen::Vector3d& middle, double halfEdge) const
    {
        const Eigen::Vector3d way = middle - point_;
        return std::abs(normal_.dot(way)) <= normal_.lpNorm<1>() * halfEdge + rounding_ * way.lpNorm<1>();
    }

private:
    Eigen::Vector3d point_, normal_;
    double rounding_ = 0; ///< of the normal, in each component
};

} // namespace

BoundarySurface::BoundarySurface(std::span<const Eigen::Vector3d> positions, std::span<const SurfaceTriangle> triangles)
    : positions_(positions), cells_(1)
{
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& position : positions)
        box.extend(position);
    if (box.isEmpty())
        box.extend(Eigen::Vector3d(0, 0, 0));
    corner_ = box.min();
    size_ = std::max(box.sizes().maxCoeff(), std::numeric_limits<double>::min()) * 1.001;
    entries_.reserve(triangles.size());
    for (const SurfaceTriangle& triangle : triangles)
        insert(triangle);
}

BoundarySurface::Place BoundarySurface::placeOf(const SurfaceTriangle& triangle) const
{
    const Eigen::AlignedBox3d box = triangleBox(positions_, triangle);
    const double extent = box.sizes().maxCoeff();
    Place place;
    double cell = size_;
    while (place.depth < deepestLevel && cell / 2 >= extent) {
        cell /= 2;
        ++place.depth;
    }
    const Eigen::Vector3d middle = (box.center() - corner_) / size_ * double(1U << deepestLevel);
    const std::uint32_t kept = ~((1U << (deepestLevel - place.depth)) - 1U);
    for (std::size_t k = 0; k < 3; ++k) {
        const double number = std::clamp(middle[Eigen::Index(k)], 0.0, double((1U << deepestLevel) - 1U));
        place.numbers[k] = static_cast<std::uint32_t>(number) & kept;
    }
    return place;
}

void BoundarySurface::insert(const SurfaceTriangle& triangle)
{
    std::uint32_t entry = freeEntry_;
    if (entry == none) {
        entry = static_cast<std::uint32_t>(entries_.size());
        entries_.emplace_back();
    } else {
        freeEntry_ = entries_[entry].next;
    }
    const Place place = placeOf(triangle);
    std::uint32_t cell = 0;
    for (int depth = 0; depth < place.depth; ++depth) {
        ++cells_[cell].triangles;
        const std::size_t child = childAt(place.numbers, depth);
        std::uint32_t next = cells_[cell].children[child];
        if (next == none) {
            next = static_cast<std::uint32_t>(cells_.size());
            cells_[cell].children[child] = next;
            cells_.emplace_back();
        }
        cell = next;
    }
    ++cells_[cell].triangles;
    entries_[entry] = {.triangle = triangle, .next = cells_[cell].first};
    cells_[cell].first = entry;
}

void BoundarySurface::remove(const SurfaceTriangle& triangle)
{
    const Place place = placeOf(triangle);
    std::uint32_t cell = 0;
    for (int depth = 0; depth < place.depth; ++depth) {
        --cells_[cell].triangles;
        cell = cells_[cell].children[childAt(place.numbers, depth)];
    }
    --cells_[cell].triangles;
    std::uint32_t* link = &cells_[cell].first;
    while (!haveSameCorners(entries_[*link].triangle, triangle))
        link = &entries_[*link].next;
    const std::uint32_t gone = *link;
    *link = entries_[gone].next;
    entries_[gone].next = freeEntry_;
    freeEntry_ = gone;
}

void BoundarySurface::replace(std::span<const SurfaceTriangle> removed, std::span<const SurfaceTriangle> added)
{
    for (const SurfaceTriangle& triangle : removed)
        remove(triangle);
    for (const SurfaceTriangle& triangle : added)
        insert(triangle);
}

bool BoundarySurface::meetsInCell(const Cell& cell, const SurfaceTriangle& triangle, const Eigen::AlignedBox3d& box,
                                  std::span<const SurfaceTriangle> removed) const
{
    for (std::uint32_t entry = cell.first; entry != none; entry = entries_[entry].next) {
        const SurfaceTriangle& other = entries_[entry].triangle;
        if (box.intersects(triangleBox(positions_, other)) && !isAmong(other, removed) &&
            surfaceTrianglesMeet(positions_, triangle, other))
            return true;
    }
    return false;
}

/// Whether visit(cell) is true of one of the cells with triangles that reach near the box, and of whose cube, given by
/// its middle and how far what is in it reaches, passes(middle, reach) is true.
template <class Passes, class Visit>
bool BoundarySurface::anyNear(const Eigen::AlignedBox3d& box, const Passes& passes, const Visit& visit) const
{
    struct Waiting {
        std::uint32_t cell;
        int depth;
        Eigen::Vector3d middle;
    };
    const double largest = corner_.cwiseAbs().maxCoeff() + size_;
    // Seven of each depth wait at most.
    std::array<Waiting, 7 * deepestLevel + 8> waiting;
    std::size_t count = 0;
    waiting[count++] = {0, 0, corner_ + Eigen::Vector3d::Constant(size_ / 2)};
    while (count > 0) {
        const Waiting at = waiting[--count];
        const Cell& cell = cells_[at.cell];
        const double size = std::ldexp(size_, -at.depth);
        // What lies in it ends half its size outside at most.
        const double reach = size + 1e-14 * largest;
        const Eigen::Array3d gap = (box.center() - at.middle).array().abs() - box.sizes().array() / 2;
        if (cell.triangles == 0 || gap.maxCoeff() > reach || !passes(at.middle, reach))
            continue;
        if (visit(cell))
            return true;
        for (std::size_t child = 0; child < 8; ++child) {
            if (cell.children[child] == none)
                continue;
            const Eigen::Vector3d way(child & 1U ? 1 : -1, child & 2U ? 1 : -1, child & 4U ? 1 : -1);
            waiting[count++] = {cell.children[child], at.depth + 1, at.middle + size / 4 * way};
        }
    }
    return false;
}

bool BoundarySurface::meetsRest(const SurfaceTriangle& triangle, std::span<const SurfaceTriangle> removed) const
{
    const Eigen::AlignedBox3d box = triangleBox(positions_, triangle);
    const RoughPlane plane(positions_, triangle, corner_.cwiseAbs().maxCoeff() + size_);
    return anyNear(
        box, [&](const Eigen::Vector3d& middle, double reach) { return plane.passes(middle, reach); },
        [&](const Cell& cell) { return meetsInCell(cell, triangle, box, removed); });
}

bool BoundarySurface::liesInside(std::span<const Tetrahedron> tetrahedra) const
{
    Eigen::AlignedBox3d box;
    for (const Tetrahedron& tetrahedron : tetrahedra)
        for (const std::uint32_t corner : tetrahedron)
            box.extend(positions_[corner]);
    const auto holds = [this](const Tetrahedron& tetrahedron, const Eigen::Vector3d& place) {
        constexpr double beyondRounding = 1e-9;
        const double volume = volumeOf(positions_, tetrahedron);
        return std::ranges::all_of(cornersOfFace, [&](const auto& face) {
            const Eigen::Vector3d &a = positions_[tetrahedron[face[0]]], &b = positions_[tetrahedron[face[1]]],
                                  &c = positions_[tetrahedron[face[2]]];
            return (a - place).dot((b - place).cross(c - place)) / 6 > beyondRounding * volume;
        });
    };
    return anyNear(
        box, [](const Eigen::Vector3d&, double) { return true; },
        [&](const Cell& cell) {
            for (std::uint32_t entry = cell.first; entry != none; entry = entries_[entry].next) {
                const auto& [a, b, c] = entries_[entry].triangle;
                const Eigen::Vector3d middle = (positions_[a] + positions_[b] + positions_[c]) / 3;
                if (std::ranges::any_of(tetrahedra, [&](const Tetrahedron& t) { return holds(t, middle); }))
                    return true;
            }
            return false;
        });
}

bool BoundarySurface::meetsItself(std::span<const SurfaceTriangle> added,
                                  std::span<const SurfaceTriangle> removed) const
{
    for (std::size_t i = 0; i < added.size(); ++i) {
        if (withoutArea(positions_, added[i]))
            return true;
        for (std::size_t j = 0; j < i; ++j) {
            if (surfaceTrianglesMeet(positions_, added[i], added[j]))
                return true;
        }
    }
    return std::ranges::any_of(added, [&](const SurfaceTriangle& triangle) { return meetsRest(triangle, removed); });
}

} // namespace tetra
